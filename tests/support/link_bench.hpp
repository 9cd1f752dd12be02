// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "tandem/coordinator/link.hpp"

namespace tandem::test {

/// One source with the outputs "a" and "b", each with a first derivative, and one link from it with a lane
/// for each.
class LinkBench {
 public:
  /// nearest: of a source with events, see Link::pass_over; 0: it has none.
  explicit LinkBench(const std::string& how, double delay = 0.0, Lane a = {0, 0}, Lane b = {1, 1},
                     double nearest = 0.0)
      : history_("source", info_, 32), link_(0, 1, reconstruction(how), delay), slots_(2) {
    link_.add(a);
    link_.add(b);
    if (nearest > 0.0) link_.pass_over(nearest), link_.expect_jumps();
    link_.attach(history_, TimeTolerance(0.0));
  }

  /// The source gives a sample: a, b and their derivatives.
  void give(double t, double a, double b = 0.0, double a_dot = 0.0, double b_dot = 0.0, bool jump = false) {
    const double row[] = {a, b, a_dot, b_dot};
    std::copy(std::begin(row), std::end(row), history_.room().append(t, jump));
    link_.extend(history_.commit(t, TimeTolerance()));
  }
  /// Samples of a function of time.
  template <class F>
  void give_all(const std::vector<double>& times, F f) {
    for (const double t : times) give(t, f(t));
  }

  /// The signal of lane a (0) or b (1) for a reader whose next own step is [from, to].
  Signal read(double from, double to, std::size_t slot = 0) {
    link_.read(from, to, slots_.data());
    return slots_[slot];
  }

  History& history() { return history_; }
  Link& link() { return link_; }

 private:
  /// "held" too, which a scenario has no word for.
  static Reconstruction reconstruction(const std::string& how) {
    return how == "held" ? Reconstruction{Reconstruction::Kind::held} : Reconstruction::parse(how);
  }
  SubsystemInfo info_{"source", {}, {{"a", "1", 1, 1}, {"b", "1", 1, 1}}, {}, {}};
  History history_;
  Link link_;
  std::vector<Signal> slots_;
};

}  // namespace tandem::test
