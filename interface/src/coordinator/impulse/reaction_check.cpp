// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/impulse/reaction_check.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kept = 0.95;  ///< of the weight of a step, when the next one comes

}  // namespace

void ReactionCheck::take(double velocity_change, double length, double acceleration, double expected) {
  const double measured =
      2.0 * velocity_change / length - acceleration - std::exchange(acceleration_, acceleration);
  count_ = kept * count_ + 1.0;
  square_ = kept * square_ + expected * expected;
  product_ = kept * product_ + expected * measured;
  measured_ = kept * measured_ + measured * measured;
}

double ReactionCheck::error() const {
  if (count_ < 3.5 || !(square_ > 0.0)) return 0.0;
  const double slope = product_ / square_, scatter = std::max(0.0, measured_ - slope * product_);
  return std::max(0.0, std::abs(slope - 1.0) - 3.0 * std::sqrt(scatter / ((count_ - 1.0) * square_)));
}

void ReactionCheck::write(ByteWriter& to) const {
  for (const double one : {acceleration_, force_, count_, square_, product_, measured_}) to.put(one);
}

void ReactionCheck::read(ByteReader& from) {
  for (double* one : {&acceleration_, &force_, &count_, &square_, &product_, &measured_})
    *one = from.take<double>();
}

}  // namespace tandem
