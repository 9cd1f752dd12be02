// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/adviser.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "cli/interrupt.hpp"
#include "cli/say.hpp"
#include "cli/sweep_study.hpp"
#include "tandem/advice/leading.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/by_signals.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/study/impulse_offer.hpp"

namespace tandem::cli {

using advice::Choice;

namespace {

/// Of models beside the scheme that they predict: a part of its error, and of the tolerance.
constexpr double most_off = 0.1, of_no_matter = 1e-3;

/// Adds the time that it lives [s].
class Stopwatch {
 public:
  explicit Stopwatch(double& to) : to_(to) {}
  ~Stopwatch() { to_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& to_;
  const Clock::time_point begin_ = Clock::now();
};

/// Of the standing study.
std::string row_of(const Choice& one) {
  return fmt::format("(schedule is {}) && (reconstruction is {}) && steps == {}", one.schedule,
                     one.reconstruction, one.steps);
}

}  // namespace

std::string words(const Choice& choice) {
  const std::string order =
      choice.order.empty() ? "" : fmt::format(", order {}", fmt::join(choice.order, " "));
  return fmt::format("{}, {}, steps x {}{}", choice.schedule, choice.reconstruction, choice.steps, order);
}

Adviser::Adviser(const scenario::Scenario& asked, std::filesystem::path folder, unsigned threads,
                 const Context& context)
    : varied_(asked.chooses ? study::Varied::left_out : study::Varied::all),
      builtins_(without_matrices(context.builtins)),
      scenario_(asked.chooses ? scenario::with_usual(asked) : scenario::by_signals(asked)),
      folder_(std::move(folder)),
      threads_(threads),
      advised_(context),
      overrides_(scenario_.overrides) {
  advised_.quiet = true;
  itself_ = advised_;
  itself_.builtins = builtins_;
  advised_.builtins = models_.replacing(builtins_);
}

std::vector<std::string> Adviser::look() {
  const Stopwatch watch(seconds_[0]);
  scenario::Assembly assembly(scenario_, advised_.builtins);
  assembly.initialize();
  auto lines = of_models();
  if (!scenario_.links.empty())
    if (const auto offer = study::impulse_offer(scenario_, builtins_); !offer.holds())
      lines.push_back("no impulse coupling is tried: " + offer.obstacle);
  if (varied_ == study::Varied::left_out) set_order(assembly.coordinator());
  if (order_.empty() && !study::states(scenario_, "/coordination/order")) find_orders();
  if (order_.empty())
    for (const std::string& line : advice::on_leading(assembly.coordinator())) lines.push_back(line);
  return lines;
}

/// As each schedule has them.
void Adviser::find_orders() {
  for (const auto kind : {Schedule::Kind::slowest_first, Schedule::Kind::fastest_first}) {
    scenario::Scenario other = scenario_;
    other.coordination.schedule = kind;
    scenario::Assembly assembly(other, advised_.builtins);
    assembly.initialize();
    if (auto all = advice::orders(assembly.coordinator()); !all.empty())
      orders_.emplace(Schedule::name(kind), std::move(all));
  }
}

/// Of runs of the subsystems themselves the first part has to do.
std::vector<std::string> Adviser::of_models() {
  std::vector<std::string> lines;
  bool shortens = false;
  for (const identification::Stand& one : models_.stands()) {
    lines.push_back(one.modelled
                        ? fmt::format("{}: a linear model of order {}, which leaves {:.2g} of its responses",
                                      of_source(one), one.order, one.residual)
                        : fmt::format("{}: runs itself; {}", of_source(one), one.why));
    shortens = shortens || !one.is_known();
  }
  if (shortens) lines.push_back("so " + shorten());
  return lines;
}

/// With the names of its subsystems.
std::string Adviser::of_source(const identification::Stand& one) const {
  std::vector<std::string> names;
  for (const scenario::SubsystemEntry& entry : scenario_.subsystems)
    if (entry.isolated
            ? one.source.find(entry.source) != std::string::npos
            : one.source == (entry.command.empty() ? entry.source : "command " + shown(entry.command)))
      names.push_back(entry.name);
  return names.empty() ? one.source : fmt::format("{} ({})", fmt::join(names, ", "), one.source);
}

/// To a part of the time.
std::string Adviser::shorten() {
  constexpr double part = 0.15;
  const double from = scenario_.judge ? scenario_.judge->measure.from : scenario_.start,
               begin = std::max(from, scenario_.start), stop = begin + part * (scenario_.stop - begin);
  up_to_ = stop;
  return fmt::format(
      "each scheme runs to {:.6g} s only, with errors, exchanges and steps of that time, and few of them to "
      "the end",
      stop);
}

/// Where the schedule is stated and the order is not. Other schedules would have other orders.
void Adviser::set_order(const Coordinator& run) {
  if (!study::states(scenario_, "/coordination/schedule") || study::states(scenario_, "/coordination/order"))
    return;
  order_ = advice::better_order(run);
  if (!order_.empty()) overrides_.push_back(advice::override_of(order_));
}

advice::Ranking Adviser::swept(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                               const study::Standing& standing, const std::string& where,
                               const Context& context) {
  sweep_study({scenario_.file,
               folder,
               overrides,
               {},
               where,
               threads_,
               false,
               false,
               study::standing_study(scenario_, builtins_, standing)},
              context);
  auto all = advice::ranking(folder / "schemes.csv");
  for (Choice& one : all.choices)
    if (one.order.empty()) one.order = order_;
  return all;
}

std::vector<std::string> Adviser::predict() {
  const Stopwatch watch(seconds_[1]);
  rank_all();
  std::vector<std::string> lines;
  if (!up_to_)
    if (auto line = check_models()) lines.push_back(std::move(*line));
  if (auto line = choose_order()) lines.push_back(std::move(*line));
  return lines;
}

void Adviser::rank_all() {
  auto overrides = overrides_;
  if (up_to_) overrides.push_back(fmt::format("span.stop={}", *up_to_));
  if (up_to_ && scenario_.recording.rows.from >= *up_to_)
    overrides.push_back(fmt::format("record.from={}", scenario_.start));  // nothing is recorded
  finest_ = {};
  finest_.is_judged = false;
  ranking_ = swept(folder_, overrides, {varied_, finest_}, "", advised_);
  if (ranking_.choices.empty())
    throw RunFailed("no scheme came to an error; " + (folder_ / "schemes.csv").string() + " tells why");
  if (up_to_) go_to_the_end();
}

/// By one run of the scheme that is chosen beside the same run of models. Nothing: there are none.
std::optional<std::string> Adviser::check_models() {
  const auto all = models_.stands();
  if (std::ranges::none_of(all, &identification::Stand::modelled)) return {};
  const Choice choice = chosen();
  const double off = off_of(choice);
  const std::string line =
      std::isinf(off) ? fmt::format("{} has no models to run beside it", words(choice))
                      : fmt::format("a run of {} itself is {:.2g} of the tolerance off that of its models",
                                    words(choice), off);
  if (off <= std::max(most_off * choice.error, of_no_matter)) return line;
  advised_ = itself_;
  const std::string how = shorten();
  rank_all();
  return line + (std::isinf(off) ? "" : ", too much beside its predicted error") +
         "; so no model is used, and " + how;
}

/// Infinite: with its steps there is no model of one of them, or one of the runs failed.
double Adviser::off_of(const Choice& choice) try {
  const study::Finest same{choice.schedule, choice.reconstruction, choice.steps, false, true};
  const auto beside = swept(folder_ / "itself", overrides_, {varied_, same}, row_of(choice), itself_);
  return beside.choices.empty() ? INFINITY : beside.choices[0].error;
} catch (const RunFailed&) {
  if (InterruptGuard::interrupted()) throw;
  return INFINITY;
}

/// Without models, beside the best scheme with half the least steps of the study.
void Adviser::go_to_the_end() {
  const Choice& best = ranking_.choices.front();
  finest_ = {best.schedule, best.reconstruction, 0.25, false};
  std::vector<std::string> rows;
  for (const Choice& one : advice::finalists(ranking_)) rows.push_back(row_of(one));
  at_end_ = swept(folder_ / "to_the_end", overrides_, {varied_, finest_},
                  fmt::format("{}", fmt::join(rows, " || ")), itself_);
  if (at_end_->choices.empty())
    throw RunFailed("no scheme came to the end; " + (folder_ / "to_the_end/schemes.csv").string() +
                    " tells why");
  beside_ = fmt::format("{}, {}, steps x {}", best.schedule, best.reconstruction, finest_.steps);
}

/// Of three subsystems and more each leads the scheme that is chosen. Nothing: there is nothing to try.
std::optional<std::string> Adviser::choose_order() {
  const Choice usual = chosen();
  const auto orders = orders_.find(usual.schedule);
  if (orders == orders_.end() || usual.is_impulse()) return {};
  const auto& first = orders->second[0];
  auto overrides = overrides_;
  overrides.push_back(advice::override_of(first));
  const auto all = swept(folder_ / "orders", overrides, {varied_, finest_, orders->second}, row_of(usual),
                         up_to_ ? itself_ : advised_);
  if (all.choices.empty()) return {};
  const Choice best = chosen_of(all);
  if (best.order == first) return "no other order is better for " + words(usual);
  led_ = best;
  return fmt::format(
      "for {} the order {} is better: error {:.3g} in place of {:.3g}, {} exchanges in place of {}",
      words(usual), fmt::join(best.order, ", "), best.error, usual.error, best.exchanges, usual.exchanges);
}

Choice Adviser::chosen_of(const advice::Ranking& all) const {
  const auto within = all.cheapest();
  return scenario_.judge && within ? *within : all.choices.front();
}

std::vector<std::string> Adviser::taken(const Choice& choice) const {
  return advice::taken(choice, scenario_, builtins_, varied_);
}

std::string Adviser::lines(const Choice& choice) const {
  return advice::lines(choice, scenario_, builtins_, varied_);
}

std::string Adviser::reason(const Choice& choice) const {
  return advice::reason(scenario::with_taken(scenario_, taken(choice)), builtins_);
}

scenario::Scenario advised(const scenario::Scenario& asked, const std::filesystem::path& folder,
                           const Context& context) {
  Adviser adviser(asked, folder, std::max(1U, std::thread::hardware_concurrency()), context);
  auto lines = adviser.look();
  for (std::string& line : adviser.predict()) lines.push_back(std::move(line));
  const Choice choice = adviser.chosen();
  if (!context.quiet) {
    for (const std::string& line : lines) say("{}\n", line);
    say("coordination.scheme = auto takes {}; its error is {:.3g} of the tolerance{}, by {}\n", words(choice),
        choice.error, choice.error <= 1.0 ? "" : ", and no other is within it", adviser.table().string());
  }
  return scenario::with_taken(asked, adviser.taken(choice));
}

}  // namespace tandem::cli
