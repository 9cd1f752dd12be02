// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/scenario/courses.hpp"

namespace tandem::study {

/// Outputs at the times of one of them, in rising order.
class Followed {
 public:
  /// times: of the output at whose rows the others are wanted. It and all tables must outlive it.
  explicit Followed(const std::vector<double>& times) : times_(times) {}

  /// slope: its derivative is wanted. Throws Error where the output has none.
  void add(const text::TimeTable& table, const std::string& output, bool slope = false);
  const std::vector<double>& times() const { return times_; }
  /// False: one of them is not known there; its value is NaN.
  bool move_to(std::size_t row);
  /// In the order in which they were added.
  const std::vector<double>& values() const { return values_; }

 private:
  struct Follower {
    scenario::Courses courses;
    scenario::Course course;
    bool slope;
    const std::vector<double>* rows;  ///< where it has the same times
  };
  const std::vector<double>& times_;
  std::vector<Follower> followers_;
  std::vector<double> values_;
};

}  // namespace tandem::study
