// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/engine/program.hpp"

namespace tandem::engine {

/// What a delay remembers, in the image of a run: points (t, u) in runs, between which the signal may have
/// jumped or bent. A view on the doubles that begin at Delay::past.
class Past {
 public:
  /// Doubles that so many points need.
  static int size(int points) { return header + per_point * points; }

  Past(const Delay& delay, double* memory) : delay_(delay), memory_(memory) {}

  /// Nothing is remembered: it gives the value from before the start.
  void clear();
  /// level: 0 goes on with the run; k begins another, where the derivative k - 1 may have jumped.
  void record(double t, double u, int level);
  double newest() const { return u(total() - 1); }
  /// When the run that is read ends; infinity while it goes on.
  double due() const;
  /// Reads the next run from now on. Returns the level at which it began.
  int turn();
  /// Whether the point before the one that is read now is still there.
  bool reaches(double t) const {
    return total() <= delay_.points || this->t(total() - delay_.points + 2) <= t;
  }

  /// The signal at t in the run that is read: the cubic through the four points of it around t, or as many as
  /// there are; before the start, its value there.
  double value(double t) const;

 private:
  static constexpr int header = 4, per_point = 3;

  // Points are numbered from 0 on; the last ones are there.
  double& initial() const { return memory_[0]; }
  long total() const { return static_cast<long>(memory_[1]); }
  long first() const { return static_cast<long>(memory_[2]); }  ///< of the run that is read; -1: before all
  long last() const { return static_cast<long>(memory_[3]); }   ///< -1: the newest
  double* point(long k) const { return memory_ + header + per_point * (k % delay_.points); }
  double t(long k) const { return point(k)[0]; }
  double u(long k) const { return point(k)[1]; }
  long interval(long low, long high, double t) const;

  const Delay& delay_;
  double* memory_;
};

/// Breaks of higher levels pass unseen: the method of order 4 keeps its order across them.
constexpr int most_levels = 4;

}  // namespace tandem::engine
