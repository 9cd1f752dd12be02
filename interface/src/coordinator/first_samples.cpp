// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../number_text.hpp"
#include "named.hpp"
#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
}

/// Subsystems need each other's first outputs as inputs. Each is initialized with what is known, NaN
/// elsewhere, and again whenever more of its inputs have become known; without an algebraic loop this ends
/// with all of them known. Where only lines with a memory or delay are left open, the reader's start value
/// closes them. A state, or what is held, may follow an input at the start alone, where nothing feeds
/// through: what was given before that input was known is passed on again where it has changed.
class FirstSamples {
 public:
  FirstSamples(const Topology& topology, std::vector<std::vector<double>>& u0,
               std::vector<std::vector<double>>& rows)
      : topology_(topology), u0_(u0), rows_(rows), due_(u0.size(), 1), corrections_(u0.size()) {}

  template <class Initialize>
  void make(const Initialize& initialize) {
    do {
      for (std::size_t i = 0; i < due_.size(); ++i) {
        if (!due_[i]) continue;
        due_[i] = 0;
        initialize(static_cast<int>(i));
        check_declared(static_cast<int>(i));
      }
      if (!pass_on() && !pass_on_changes()) close_lags();
    } while (std::find(due_.begin(), due_.end(), 1) != due_.end());
  }

 private:
  /// Known: finite, and independent of inputs that are not known yet, as all are that hold before a first
  /// instant.
  bool known(int i, int output) const {
    if (topology_.info(i).abilities.sampled) return true;
    const auto& feed = topology_.info(i).feedthrough;
    return std::none_of(feed.begin(), feed.end(), [&](const Feedthrough& f) {
      return f.output == output &&
             std::isnan(u0_[static_cast<std::size_t>(i)][static_cast<std::size_t>(f.input)]);
    });
  }

  void check_declared(int i) const {
    for (int k = 0; k < topology_.info(i).output_size(); ++k)
      if (known(i, k) && !std::isfinite(rows_[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]))
        throw Error(ErrorCode::numerical,
                    "output " + topology_.output_name(i, k) +
                        " is not finite at the start, though no unknown input feeds through to it");
  }

  /// Gives each input that `which` names what its sources give, if they are all known; true if one is new.
  template <class Which>
  bool set_inputs(const Which& which) {
    bool any = false;
    for (std::size_t i = 0; i < u0_.size(); ++i)
      for (std::size_t k = 0; k < u0_[i].size(); ++k) {
        if (!which(static_cast<int>(i), static_cast<int>(k))) continue;
        const double value = sum_of_lines(static_cast<int>(i), static_cast<int>(k));
        if (std::isnan(value) || value == u0_[i][k]) continue;
        u0_[i][k] = value;
        due_[i] = 1;
        any = true;
      }
    return any;
  }

  bool pass_on() {
    return set_inputs([this](int i, int k) { return std::isnan(input(i, k)); });
  }

  /// A chain of changes is no longer than there are subsystems.
  bool pass_on_changes() {
    const bool any = corrections_ > 0 &&
                     set_inputs([this](int i, int k) { return !std::isnan(input(i, k)) && !stays(i, k); });
    if (any) --corrections_;
    return any;
  }

  /// It is not connected, or closed a loop by its start value.
  bool stays(int reader, int input) const {
    return topology_.lines_to(reader, input).empty() ||
           std::find(closed_.begin(), closed_.end(), std::pair(reader, input)) != closed_.end();
  }

  double sum_of_lines(int reader, int input) const {
    double sum = 0.0;
    for (const int number : topology_.lines_to(reader, input)) {
      const Line& line = topology_.lines()[static_cast<std::size_t>(number)];
      if (!known(line.source, line.output)) return not_known;
      sum += line.gain * rows_[static_cast<std::size_t>(line.source)][static_cast<std::size_t>(line.output)] +
             line.offset;
    }
    return sum;
  }

  /// Gives one input that closes a loop through a memory or delay its start value: the first by name, in
  /// whatever order the connections stand.
  void close_lags() {
    const Line* first = nullptr;
    const auto name = [&](const Line& line) { return topology_.input_name(line.reader, line.input); };
    for (const Line& line : topology_.lines())
      if (line.lag != Lag::none && std::isnan(value(line)) && in_loop(line) &&
          (!first || name(line) < name(*first)))
        first = &line;
    if (!first) return;
    const double start = topology_.start(first->reader)[static_cast<std::size_t>(first->input)];
    if (std::isnan(start))
      throw Error(ErrorCode::invalid_argument,
                  "input " + name(*first) + " closes a loop with a memory or delay and has no start value");
    value(*first) = start;
    closed_.emplace_back(first->reader, first->input);
    due_[static_cast<std::size_t>(first->reader)] = 1;
  }

  double& value(const Line& line) { return input(line.reader, line.input); }
  double& input(int i, int k) { return u0_[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]; }

  /// The line's input reaches its output, over feedthrough and any lines.
  bool in_loop(const Line& line) const {
    std::vector<const Line*> path{&line}, seen;
    while (!path.empty()) {
      const Line* at = path.back();
      path.pop_back();
      seen.push_back(at);
      for (const int number : topology_.lines_from(at->reader)) {
        const Line& next = topology_.lines()[static_cast<std::size_t>(number)];
        if (!feeds(at->reader, at->input, next.output)) continue;
        if (&next == &line) return true;
        if (std::find(seen.begin(), seen.end(), &next) == seen.end()) path.push_back(&next);
      }
    }
    return false;
  }

  bool feeds(int i, int input, int output) const {
    const auto& feed = topology_.info(i).feedthrough;
    return std::any_of(feed.begin(), feed.end(),
                       [&](const Feedthrough& f) { return f.input == input && f.output == output; });
  }

  const Topology& topology_;
  std::vector<std::vector<double>>& u0_;
  std::vector<std::vector<double>>& rows_;
  std::vector<char> due_;
  std::size_t corrections_;                  ///< rounds that may still change what was known
  std::vector<std::pair<int, int>> closed_;  ///< inputs whose start value closes a loop
};

void RunStart::first_samples() {
  for (int i = 0; i < topology_.size(); ++i) {
    const auto& start = topology_.start(i);
    auto& u0 = u0_.emplace_back(start.size(), not_known);
    for (std::size_t k = 0; k < start.size(); ++k)
      if (const TimeSeries* series = topology_.series(i, static_cast<int>(k)))
        u0[k] = series->value(run_.t_start_);
      else if (topology_.lines_to(i, static_cast<int>(k)).empty())
        u0[k] = start[k];
    rows_.emplace_back(static_cast<std::size_t>(topology_.info(i).row_size() - Samples::header));
  }
  clocks_.resize(u0_.size());
  FirstSamples(topology_, u0_, rows_).make([this](int i) {
    const auto k = static_cast<std::size_t>(i);
    std::vector<double> memory(static_cast<std::size_t>(topology_.info(i).row_size()));
    Samples y(memory.data(), topology_.info(i).row_size(), 1);
    clocks_[k] = named(topology_.name(i), [&] {
      return run_.seats_[k].subsystem->initialize(run_.t_start_, run_.t_stop_, u0_[k], y);
    });
    const auto fail = [&](const std::string& found) {
      throw Error(ErrorCode::numerical,
                  "subsystem '" + topology_.name(i) + "' " + found +
                      " when initialized; allowed is one sample, and the clock, at t = " +
                      number_text(run_.t_start_) + " s");
    };
    if (y.size() != 1) fail("gave " + std::to_string(y.size()) + " samples");
    if (y.time(0) != run_.t_start_) fail("gave a sample at t = " + number_text(y.time(0)) + " s");
    if (clocks_[k].time != run_.t_start_) fail("stands at t = " + number_text(clocks_[k].time) + " s");
    rows_[k].assign(memory.begin() + Samples::header, memory.end());
  });
}

}  // namespace tandem
