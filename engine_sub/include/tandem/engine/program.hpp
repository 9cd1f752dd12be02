// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tandem/engine/compiled_block.hpp"
#include "tandem/engine/curve.hpp"
#include "tandem/engine/description.hpp"
#include "tandem/engine/operation.hpp"
#include "tandem/engine/surface.hpp"
#include "tandem/time_series.hpp"

namespace tandem::engine {

/// out <- from, with the values from before the event.
struct Update {
  int to, from;
};

/// What happens at an instant that is not known before: the sign of a signal changes.
struct Crossing {
  enum class Direction : std::uint8_t { rising, falling, both };
  int signal, sign;  ///< Slots: of the signal, and of its sign as last seen (1 or -1).
  Direction direction;
  std::vector<Update> updates;
  std::string name;         ///< Of its block.
  bool sees_start = false;  ///< A signal above 0 at the start has risen there.
  bool repeats = false;     ///< Its updates make the signal fall; if it is above 0 even so, it rises again.
  int bound = -1;           ///< Of a signal that leaves its limits: which of Program::bounds.
  int loop = -1;  ///< Of a signal that follows from an algebraic loop: the last such of Program::loops.
  /// Of one that puts a state, two slots: when that was, while it is not known whether its signal turns back
  /// (-infinity: it is known), and whether it did the last time.
  int turn = -1;
};

/// What happens at offset + k period after the start of a run, k = 0, 1, ..
struct Periodic {
  double period, offset;
  int count;  ///< slot of the next k
  std::vector<Update> updates;
  std::string name;
};

/// Data over time jump where they go on to the next run of theirs.
struct DataJumps {
  int data;          ///< which of Program::data
  int run;           ///< slot of the run's number
  std::string name;  ///< of its block
};

/// What a delay remembers stands in the image from `past` on (src/past.hpp).
struct Delay {
  int past, points;  ///< a slot; at most so many points
  int from;          ///< the signal
  double time;       ///< [s]
  std::string name;  ///< of its block
};

/// Operations that need their own results: from the values of signals at which the loop is cut they make new
/// ones, and have to be repeated until they are the same.
struct Loop {
  int first, last;        ///< operations, the second past the end
  std::vector<int> cuts;  ///< slots
  std::string blocks;     ///< "a, b, c"
  LoopSettings settings;
};

/// A signal that has to stay between two values.
struct Range {
  int signal;
  double low, high;
  std::string owner, what;  ///< "block 'f' of kind table", "its input"
};

/// What is said where a signal passes a limit.
struct Bound {
  std::string what, sentence;  ///< "limit 'range': signal 'N' is below 83.8"
  bool stops;                  ///< the run ends
};

/// An output's course.
struct Course {
  bool held;   ///< constant from event to event, and not for ever
  bool jumps;  ///< events may change it at once
};

/// A diagram compiled: operations in the order of evaluation. All that changes during a run stands in one
/// image of doubles. States are first, then there is room for those of a reaction. Time, inputs, held values, signs,
/// results of operations and constants follow, then what delays remember, and what is remembered of the run itself.
struct Program {
  int states = 0, time = 0;
  int room() const { return time - states; }  ///< slots for the states of a reaction
  std::vector<int> inputs, outputs;           ///< Slots.
  std::vector<int> rates;                     ///< By state: the slot of its derivative.
  std::vector<Course> courses;                ///< By output.
  std::vector<int> output_rates;  ///< By output: the slot of its derivative, -1; empty if there is none.
  /// Of a program whose outputs change at its periodic events alone, which has no state but what is held: no
  /// two of its instants are nearer to each other [s]. 0 of any other.
  double shortest_period = 0.0;
  /// (output, input): that output depends on that input at once, of a sampled one at an instant.
  std::vector<std::pair<int, int>> feedthrough;
  std::vector<Operation> operations;
  int rate_operations = 0;  ///< So many of them, the first, are all that derivatives need.
  int step_operations = 0;  ///< So many of them are all that is needed but at events.
  std::vector<double> parameters;
  std::vector<Curve> curves;
  std::vector<Surface> surfaces;
  std::vector<TimeSeries> data;
  std::vector<DataJumps> data_jumps;  ///< Of those that have jumps.
  std::vector<CompiledBlock::Function> calls;
  std::vector<Delay> delays;
  std::vector<Loop> loops;  ///< In the order of their operations.
  std::vector<Crossing> crossings;
  std::vector<Periodic> periodics;
  std::vector<Update> step_updates;  ///< At the beginning of each own step.
  std::vector<Range> ranges;
  std::vector<Bound> bounds;
  std::vector<double> breaks;      ///< Where sources have a kink [s], ascending.
  std::vector<Update> starts;      ///< Values at the start that come from signals.
  std::vector<Update> settled;     ///< Modes; at the start both are repeated until nothing changes.
  std::vector<double> image;       ///< At the start.
  int step_begun = 0, events = 0;  ///< Slots: whether an own step is under way, and its events so far.
  int longest_step = 0;            ///< Slot: of own steps so far.
  int sizes = 0;                   ///< Slots: by output, the largest magnitude so far.
  std::vector<std::string> state_names, signal_names;  ///< The second by slot; empty: no name.
  std::vector<std::string> signal_blocks;              ///< By slot: the block that makes it.
  std::map<std::string, std::string> places;           ///< Of blocks by name: "FILE:LINE".
  std::vector<std::string> left_out;                   ///< Blocks that feed no output.

  /// "block 'f' (engine.toml:12)".
  std::string named(const std::string& block) const;
  /// "block 'f' (engine.toml:12) gives nan": the first operation before `last` that makes what is not finite
  /// out of what is; empty if there is none.
  std::string not_finite(const double* image, int last) const;

  bool sampled() const { return shortest_period > 0.0; }
  /// Whether events may change an output at once.
  bool jumps() const;
  /// The outputs in an image, and then their derivatives, if one of them is a state (0 for those that are
  /// not).
  void row(const double* image, double* y) const;

  /// Operations from `first` to before `last`, each once.
  void run(double* signals, int first, int last) const;
};

}  // namespace tandem::engine
