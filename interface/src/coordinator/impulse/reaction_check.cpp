// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/impulse/reaction_check.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

/// Of the largest one so far, for a step that tells something of A: below it solvers and rounding have their say.
constexpr double least_change = 1e-4;
constexpr double least_part = 0.01;  ///< of the squares of what is measured, by the changes of the force
constexpr double kept = 0.95;        ///< of the weight of a step, when the next one comes

}  // namespace

void ReactionCheck::take(double velocity_change, double length, double acceleration, double answer,
                         double change) {
  const double free = acceleration - answer, second = free - 2.0 * free_[0] + free_[1];
  largest_ = std::max(largest_, std::abs(change));
  if (taken_ > 1 && std::abs(change_) > least_change * largest_) add(0.5 * (second_ + second));
  measured_ = 2.0 * velocity_change / length - acceleration - std::exchange(acceleration_, acceleration);
  free_[1] = free_[0], free_[0] = free, second_ = second, change_ = change;
  ++taken_;
}

/// The step before, with the second difference in its middle.
void ReactionCheck::add(double f) {
  const double c = change_, m = measured_;
  count_ = kept * count_ + 1.0;
  cc_ = kept * cc_ + c * c, cf_ = kept * cf_ + c * f, ff_ = kept * ff_ + f * f;
  cm_ = kept * cm_ + c * m, fm_ = kept * fm_ + f * m, mm_ = kept * mm_ + m * m;
}

/// By least squares of m = share * change + c * f.
double ReactionCheck::error() const {
  const double determinant = cc_ * ff_ - cf_ * cf_;
  if (count_ < 4.0 || !(determinant > 1e-12 * cc_ * ff_) || cc_ < least_part * mm_) return 0.0;
  const double share = (cm_ * ff_ - fm_ * cf_) / determinant, c = (fm_ * cc_ - cm_ * cf_) / determinant;
  const double scatter = std::max(0.0, mm_ - share * cm_ - c * fm_) + 1e-4 * c * c * ff_;
  const double free = count_ - 2.0, errors = 3.0 + 36.0 / std::pow(free, 1.5);  // of few steps more
  return std::max(0.0, std::abs(share - 1.0) - errors * std::sqrt(scatter / free * ff_ / determinant));
}

void ReactionCheck::write(ByteWriter& to) const {
  ReactionCheck copy = *this;
  for (const double* one : copy.numbers()) to.put(*one);
}

void ReactionCheck::read(ByteReader& from) {
  for (double* one : numbers()) *one = from.take<double>();
}

}  // namespace tandem
