// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>

#include "tandem/check.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::checks {

/// The contract is broken. what() says how.
struct Broken : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The check does not apply. what() says why.
struct LeftOut : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const std::string& sentence) {
  if (!holds) throw Broken(sentence);
}

/// Rows of samples, one after another.
using Rows = std::vector<std::vector<double>>;

/// Throws Broken, with the first difference, where two lists are not the same to the last bit.
void require_same(const Rows& found, const Rows& expected, const std::string& what);

/// What is checked.
struct Subject {
  const Opener& open;
  const CheckSettings& settings;
};

/// One instance, driven call by call, with all the rows that it gave. Each call is checked: rows within the
/// room given, the clock at the newest of them, numbers finite. Each input is a parabola over a span, a cubic
/// after it.
class Instance {
 public:
  explicit Instance(const Subject& of);

  /// Starts, with a new list of rows.
  Clock initialize(const std::vector<double>& u0);
  Clock initialize() { return initialize(u0_); }
  /// Starts at another time [s], with its inputs there.
  Clock initialize_at(double t);
  /// One call with room for so many rows.
  Clock call_once(double t_limit, bool land = false, std::int64_t room = 1'000);
  /// The same, and of one with events as many as there are events on the way.
  void advance(double t_limit, bool land = false, std::int64_t room = 1'000);
  /// As many calls as it takes to get there, each with that much room.
  void go_to(double t_limit, bool land = false, std::int64_t room = 1'000);

  /// From here on its first input has this besides, and rows end with so many states; null: nothing.
  void react(const tandem_reactive_input* by, std::int32_t states);
  /// From here on, by so much.
  void raise_first_input(double by);
  /// From here on its last input is constant but for a jump at t, which is known before.
  void let_last_input_jump(double t);

  const Abilities& can() const { return subsystem->info().abilities; }
  double step() const { return clock.next_time - clock.time; }
  /// A time some steps ahead that is no node.
  double ahead(double steps) const { return clock.time + steps * step(); }
  const TimeTolerance& tolerance() const { return tolerance_; }

  std::unique_ptr<Subsystem> subsystem;
  Clock clock{};
  Rows rows;

 private:
  template <class Call>
  Clock call(std::int64_t room, const Call& make);
  void take(const std::vector<double>& memory, const Samples& y, std::int64_t first);
  void make_signals(const std::vector<double>& inputs, const std::vector<bool>& constant);

  double t_start_;
  TimeTolerance tolerance_;
  std::vector<std::vector<Segment>> pieces_;
  std::vector<Signal> signals_;
  std::vector<double> u0_;
  std::int64_t states_ = 0;  ///< of a reaction
};

/// All rows up to t by one advance of another instance.
Rows in_one_call(const Subject& of, double t, bool land = false);

}  // namespace tandem::checks
