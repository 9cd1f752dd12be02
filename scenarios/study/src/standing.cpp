// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/standing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "known_steps.hpp"
#include "standing_metrics.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/by_signals.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/study/impulse_offer.hpp"

namespace tandem::study {
namespace {

constexpr double usual_tolerance = 0.01;  // of the peak

/// By "instance.port".
std::map<std::string, Port> outputs_of(const Topology& topology) {
  std::map<std::string, Port> all;
  for (int i = 0; i < topology.size(); ++i)
    for (const Port& port : topology.info(i).outputs) all[topology.name(i) + "." + port.name] = port;
  return all;
}

/// Writes the study of a scenario.
class Writer {
 public:
  Writer(const scenario::Scenario& scenario, const Builtins& builtins, const Standing& standing)
      : scenario_(scenario),
        varied_(standing.varied),
        finest_(standing.finest),
        orders_(standing.orders),
        outputs_(outputs_of(scenario::Parts(scenario, builtins, scenario::Code::run).topology())) {
    if (scenario.connections.empty())
      throw Error(
          ErrorCode::invalid_argument,
          scenario.file.string() + " has no connection; allowed is a scenario with at least one, or a study");
  }

  std::vector<std::size_t> free_connections() const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < scenario_.connections.size(); ++k)
      if (is_free(k)) all.push_back(k);
    return all;
  }

  std::string text(const Builtins& builtins) {
    varies_steps_ = scenario::can_scale_steps(scenario_, builtins);
    if (!varies_steps_) leave_unknown_steps(builtins);
    if (varied_ == Varied::left_out) leave_stated(builtins);
    if (may_be_impulse()) offer_ = impulse_offer(scenario_, builtins);
    find_judged();
    const auto all = words();
    return head() + reconstructions() + block(schedules_, all, all, Words(all.size(), "signals")) +
           of_impulse() + reference() + standing_metrics(judged_, scenario_, finest_.is_judged) +
           standing_charts(finest_.is_judged);
  }

 private:
  using Words = std::vector<std::string>;

  /// how: the reconstruction that is set.
  std::string block(const Words& schedules, const Words& reconstructions, const Words& how,
                    const Words& couplings) const {
    const auto listed = [](const Words& all) { return fmt::format("[\"{}\"]", fmt::join(all, "\", \"")); };
    const std::string more =
        offer_.holds() ? fmt::format(", how = {}, coupling = {}", listed(how), listed(couplings)) : "";
    return fmt::format(R"toml(
[[tables.schemes.blocks]]
axes = [
  {{ schedule = {} }},
  {{ reconstruction = {}{} }},
  {{ steps = [{}] }},{}
]
)toml",
                       listed(schedules), listed(reconstructions), more, varies_steps_ ? "0.5, 1, 2" : "1",
                       orders());
  }

  /// Columns order_0, .. that move together.
  std::string orders() const {
    std::string text;
    for (std::size_t place = 0; place < places(); ++place) {
      Words names;
      for (const auto& order : orders_) names.push_back(order[place]);
      text += fmt::format("{}order_{} = [\"{}\"]", place > 0 ? ", " : "", place, fmt::join(names, "\", \""));
    }
    return text.empty() ? "" : fmt::format("\n  {{ {} }},", text);
  }
  std::size_t places() const { return orders_.empty() ? 0 : orders_[0].size(); }

  std::string of_impulse() const {
    const Words& all = offer_.couplings;
    return all.empty() ? "" : block({"fastest-first"}, all, Words(all.size(), "lagrange3"), all);
  }

  /// Of what is left out: where neither the coupling, nor another schedule, nor how a link is reconstructed is stated.
  bool may_be_impulse() const {
    const auto is_left = [this](std::size_t k) {
      return !is_of_link(scenario_, scenario_.connections[k].connection.to) || is_free(k);
    };
    std::vector<std::size_t> all(scenario_.connections.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return !scenario_.links.empty() && (varied_ == Varied::all || !stated("/coordination/coupling")) &&
           std::all_of(all.begin(), all.end(), is_left) &&
           std::find(schedules_.begin(), schedules_.end(), "fastest-first") != schedules_.end();
  }

  /// The reference has shorter own steps where that can be, and can't be judged.
  void leave_unknown_steps(const Builtins& builtins) {
    finer_ = known_steps(scenario_, builtins, finest_.steps);
    finest_.steps = 1.0, finest_.is_judged = false;
  }

  /// What is stated is not varied.
  void leave_stated(const Builtins& builtins) {
    if (stated("/coordination/schedule"))
      schedules_ = {std::string(Schedule::name(scenario_.coordination.schedule))};
    varies_steps_ = varies_steps_ && !states_steps(scenario_, builtins);
    if (schedules_.size() == 1 && !varies_steps_ && free_connections().empty())
      scenario::refuse(
          scenario_.place("coordination.scheme"),
          "coordination.scheme is auto, and the scenario leaves nothing out; allowed is stated, or a "
          "scenario without a schedule, a reconstruction or a step");
  }
  bool stated(const std::string& path) const { return states(scenario_, path); }

  std::vector<std::string> words() const {
    return free_connections().empty() ? std::vector<std::string>{"stated"} : Reconstruction::words();
  }

  /// Null: it is not there.
  const Port* output(const std::string& name) const {
    const auto found = outputs_.find(name.substr(0, name.find('[')));
    return found == outputs_.end() ? nullptr : &found->second;
  }

  /// Its reconstruction is varied: that of an output that is not held, without a lag.
  bool is_free(std::size_t k) const {
    const auto& entry = scenario_.connections[k];
    const Port* port = output(entry.connection.from);
    const bool given =
        varied_ == Varied::left_out && stated(fmt::format("/connections/{}/reconstruction", k));
    return !given && !(port && port->held) && entry.connection.lag == Lag::none;
  }

  void find_judged() {
    if (const auto& judge = scenario_.judge) {
      judged_.push_back({judge->quantity, judge->tolerance, judge->measure});
      return;
    }
    for (const auto& entry : scenario_.connections) {
      const std::string& from = entry.connection.from;
      if (offer_.holds() && is_back_of_link(scenario_, from)) continue;
      const Port* port = output(from);
      const bool is_vector = port && port->size > 1 && !from.ends_with("]");
      for (int k = 0; k < (is_vector ? port->size : 1); ++k)
        add(is_vector ? fmt::format("{}[{}]", from, k) : from);
    }
  }

  void add(const std::string& output) {
    if (std::none_of(judged_.begin(), judged_.end(),
                     [&](const JudgedOutput& one) { return one.name == output; }))
      judged_.push_back({output, usual_tolerance, {}});
  }

  std::string head() const {
    return fmt::format(
        R"toml(# The study of a scenario that has none. Rows are good enough where error is at most 1.
scenario = "{}"
steps = "$steps"
columns = ["schedule", "reconstruction", "steps", "error", {}"exchanges", "own_steps"]

[set]
"coordination.schedule" = "$schedule"
{}{})toml",
        scenario_.file.filename().string(), finest_.is_judged ? "\"reference_error\", " : "", couplings(),
        stated("/coordination/scheme") ? "\"coordination.scheme\" = \"stated\"\n" : "");
  }

  /// Of a scenario that states another one, too.
  std::string couplings() const {
    return offer_.holds()
               ? fmt::format("\"coordination.coupling\" = \"$coupling\"\n\"coordination.fast_period\" = {}\n",
                             offer_.fast_period)
           : stated("/coordination/coupling") ? "\"coordination.coupling\" = \"signals\"\n"
                                              : "";
  }

  std::string reconstructions() const {
    std::string text;
    for (std::size_t place = 0; place < places(); ++place)
      text += fmt::format("\"coordination.order[{}]\" = \"$order_{}\"\n", place, place);
    for (const std::size_t k : free_connections())
      text += fmt::format("\"connections[{}].reconstruction\" = \"${}\"\n", key_of(scenario_, k),
                          offer_.holds() ? "how" : "reconstruction");
    return text;
  }

  /// Of hermite, where there are derivatives, else lagrange3.
  std::string reference() const {
    std::string more = coupling_of_reference();
    for (std::size_t place = 0; place < places(); ++place)
      more += fmt::format(", order_{} = \"{}\"", place, orders_[0][place]);
    std::string text = fmt::format(
        "\n[references.fine]\nwith = {{ schedule = \"{}\", reconstruction = \"{}\", steps = {}{} }}\n{}"
        "\n[references.fine.set]\n",
        finest_.schedule, finest_.reconstruction, finest_.steps, more,
        finest_.is_judged   ? "floor = true\n"
        : finest_.of_models ? "models = true\n"
                            : "");
    text += finer_;
    for (std::size_t k = 0; k < scenario_.connections.size(); ++k) {
      const Connection& one = scenario_.connections[k].connection;
      if (const Port* port = output(one.from);
          finest_.reconstruction == "hermite" && is_free(k) && port && port->derivatives == 0)
        text += fmt::format("\"connections[{}].reconstruction\" = \"lagrange3\"\n", key_of(scenario_, k));
    }
    return text;
  }

  /// A word of a coupling stands for cubic reconstructions of what it leaves.
  std::string coupling_of_reference() const {
    if (!offer_.holds()) return "";
    const std::string& how = finest_.reconstruction;
    const bool is_coupling = how.starts_with("impulse"), is_usual = finest_.schedule == Finest{}.schedule &&
                                                                    how == Finest{}.reconstruction &&
                                                                    finest_.steps == Finest{}.steps;
    return fmt::format(", how = \"{}\", coupling = \"{}\"", is_coupling ? "lagrange3" : how,
                       is_coupling ? how
                       : is_usual  ? "impulse"
                                   : "signals");
  }

  const scenario::Scenario& scenario_;
  const Varied varied_;
  Finest finest_;
  std::string finer_;  ///< steps of the reference
  const std::vector<std::vector<std::string>> orders_;
  const std::map<std::string, Port> outputs_;
  std::vector<std::string> schedules_ = {"slowest-first", "fastest-first", "staggered", "parallel"};
  bool varies_steps_ = true;
  ImpulseOffer offer_;
  std::vector<JudgedOutput> judged_;
};

}  // namespace

bool states(const scenario::Scenario& scenario, const std::string& path) {
  return nlohmann::json::parse(scenario.values).contains(nlohmann::json::json_pointer(path));
}

std::string standing_study(const scenario::Scenario& scenario, const Builtins& builtins,
                           const Standing& standing) {
  const auto apart = scenario::by_signals(scenario);
  return Writer(apart, builtins, standing).text(builtins);
}

std::string key_of(const scenario::Scenario& scenario, std::size_t connection) {
  const auto& all = scenario.connections;
  const std::string& to = all[connection].connection.to;
  const auto is_alike = [&](const scenario::ConnectionEntry& one) { return one.connection.to == to; };
  return std::ranges::count_if(all, is_alike) == 1 ? to : std::to_string(connection);
}

std::vector<std::size_t> free_connections(const scenario::Scenario& scenario, const Builtins& builtins,
                                          Varied varied) {
  return Writer(scenario, builtins, {varied}).free_connections();
}

}  // namespace tandem::study
