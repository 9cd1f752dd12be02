// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/adviser.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

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
  return fmt::format("{}, {}, steps x {}", choice.schedule, choice.reconstruction, choice.steps);
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
  if (order_.empty())
    for (const std::string& line : advice::on_leading(assembly.coordinator())) lines.push_back(line);
  return lines;
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
    if (one.source == (entry.command.empty() ? entry.source : "command " + shown(entry.command)))
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
  const auto order = advice::better_order(run);
  if (order.empty()) return;
  order_.push_back(fmt::format("coordination.order=[\"{}\"]", fmt::join(order, "\", \"")));
  overrides_.push_back(order_.front());
}

advice::Ranking Adviser::swept(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                               const study::Finest& finest, const std::string& where,
                               const Context& context) {
  sweep_study({scenario_.file,
               folder,
               overrides,
               {},
               where,
               threads_,
               false,
               false,
               study::standing_study(scenario_, builtins_, varied_, finest)},
              context);
  return advice::ranking(folder / "schemes.csv");
}

std::vector<std::string> Adviser::predict() {
  const Stopwatch watch(seconds_[1]);
  rank_all();
  if (up_to_) return {};
  const auto line = check_models();
  return line ? std::vector{*line} : std::vector<std::string>{};
}

void Adviser::rank_all() {
  auto overrides = overrides_;
  if (up_to_) overrides.push_back(fmt::format("span.stop={}", *up_to_));
  study::Finest finest;
  finest.is_judged = false;
  ranking_ = swept(folder_, overrides, finest, "", advised_);
  if (ranking_.choices.empty())
    throw RunFailed("no scheme came to an error; " + (folder_ / "schemes.csv").string() + " tells why");
  if (up_to_) go_to_the_end();
}

/// By one run of the scheme that is chosen beside the same run of models. Nothing: there are none.
std::optional<std::string> Adviser::check_models() {
  const auto all = models_.stands();
  if (std::ranges::none_of(all, &identification::Stand::modelled)) return {};
  const Choice choice = chosen();
  const study::Finest same{choice.schedule, choice.reconstruction, choice.steps, false, true};
  const auto beside = swept(folder_ / "itself", overrides_, same, row_of(choice), itself_);
  const double off = beside.choices.empty() ? INFINITY : beside.choices[0].error;
  const std::string line =
      fmt::format("a run of {} itself is {:.2g} of the tolerance off that of its models", words(choice), off);
  if (off <= std::max(most_off * choice.error, of_no_matter)) return line;
  advised_ = itself_;
  const std::string how = shorten();
  rank_all();
  return line + ", too much beside its predicted error; so models are left, and " + how;
}

/// Without models, beside the best scheme with half the least steps of the study.
void Adviser::go_to_the_end() {
  const Choice& best = ranking_.choices.front();
  const study::Finest finest{best.schedule, best.reconstruction, 0.25, false};
  std::vector<std::string> rows;
  for (const Choice& one : advice::finalists(ranking_)) rows.push_back(row_of(one));
  at_end_ =
      swept(folder_ / "to_the_end", overrides_, finest, fmt::format("{}", fmt::join(rows, " || ")), itself_);
  if (at_end_->choices.empty())
    throw RunFailed("no scheme came to the end; " + (folder_ / "to_the_end/schemes.csv").string() +
                    " tells why");
  beside_ = fmt::format("{}, {}, steps x {}", best.schedule, best.reconstruction, finest.steps);
}

Choice Adviser::chosen() const {
  const auto within = cheapest();
  return scenario_.judge && within ? *within : last().choices.front();
}

std::vector<std::string> Adviser::taken(const Choice& choice) const {
  auto all = advice::taken(choice, scenario_, builtins_, varied_);
  all.insert(all.end(), order_.begin(), order_.end());
  return all;
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
        choice.error, adviser.cheapest() ? "" : ", and no other is within it",
        (folder / (adviser.beside().empty() ? "" : "to_the_end") / "schemes.csv").string());
  }
  return scenario::with_taken(asked, adviser.taken(choice));
}

}  // namespace tandem::cli
