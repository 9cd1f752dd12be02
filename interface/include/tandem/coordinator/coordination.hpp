// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/coordinator/history.hpp"
#include "tandem/coordinator/schedule.hpp"

namespace tandem {

/// How histories are filled before the first step, so that degree d gives global order d + 1 from the
/// beginning.
enum class StartKind {
  automatic,    ///< Derivatives if the outputs give enough of them, else repeat if all can restart, else cold
                ///< (noted).
  derivatives,  ///< Past samples by Taylor expansion of the output derivatives at the start.
  repeat,       ///< The first steps are run again and again, on inputs interpolated in the pass before;
                ///< cold (noted) where that does not settle, or an output jumps there.
  cold,         ///< As many samples as there are; caps the order at 2 (extrapolated) and 3 (interpolated).
};
/// "automatic", "derivatives", "repeat", "cold".
std::string_view name(StartKind start);

/// Whether a subsystem that can cut a step ends one at each instant of a sampled one, from which it reads or
/// which reads it.
enum class Landing {
  automatic,  ///< if the period of that one is at least its own step
  always,
  never,
};

/// From "automatic", "always", "never"; throws Error(invalid_argument) that lists these for any other text.
Landing landing(std::string_view text);

/// The coordination of a run, as a scenario states it.
struct Coordination {
  Schedule::Kind schedule = Schedule::Kind::slowest_first;
  /// Instances that integrate themselves, slowest first; empty: by the length of their own steps. Of equal
  /// ones who has events, or feeds a held input through, leads; who feeds another input through at once
  /// follows; else names decide. A note tells it.
  std::vector<std::string> order;
  std::map<std::string, Landing> landing;  ///< by instance; automatic where it is not there
  /// [s], for parallel and for delays; default: the nodes of the largest own step.
  std::optional<double> communication_step;
  StartKind start = StartKind::automatic;
  /// It is made by Coordinator::run_to, to points of time that are not known when it starts. A repeated start then
  /// goes by what open inputs are at the start, and makes a past: the run goes on from the start itself.
  bool pauses = false;
  /// A run ends (Diverged) where an output grows beyond so many times the largest of its magnitude in the
  /// first hundredth of the span, its port's nominal value and 1; above 1, infinite: never.
  double diverged_beyond = 1e8;
  bool profile = false;  ///< read the clock before and after each call of a subsystem
  /// That make calls of one round at the same time, where these last long enough; the results are the same.
  int threads = 1;
};

/// Is told of new samples as they become visible.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Rows first..last of the subsystem's history are new. Called after each turn (parallel: for each
  /// subsystem after the round). Returns false to end the run.
  virtual bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) = 0;
  /// It has gone over the span on these signals: its inputs, and behind them the terms of those that are sums
  /// (Exchange::slot). Its new rows are told later. Valid until the call returns.
  virtual void inputs(int /*subsystem*/, TimeSpan /*span*/, std::span<const Signal> /*lanes*/) {}
  /// It is sampled, and has acted at t [s] on these values, as above; of several calls for one t the last one counts.
  virtual void inputs_at(int /*subsystem*/, double /*t*/, std::span<const double> /*lanes*/) {}
  /// It stands at t [s] again, to go from there on other inputs. No row that was told is taken back.
  virtual void went_back(int /*subsystem*/, double /*t*/) {}
  /// Called by Coordinator::run after each round that is followed by another, with all samples made known:
  /// the place for input and output. Whoever calls round() in a loop of his own calls this too.
  virtual void between_rounds() {}
};

/// Figures of one subsystem's part in a run.
struct Effort {
  std::int64_t exchanges = 0;    ///< calls of advance
  std::int64_t steps = 0;        ///< own steps
  std::int64_t start_steps = 0;  ///< own steps in the passes of a repeated start, apart from the above
  double seconds = 0.0;          ///< inside advance, the start's too; with `profile` only
};

}  // namespace tandem
