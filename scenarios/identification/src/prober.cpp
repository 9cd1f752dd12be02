// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "prober.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::identification {

using Eigen::MatrixXd;

Prober::Prober(Subsystem& subsystem, const Wanted& wanted) : probe_(subsystem, wanted), wanted_(wanted) {
  for (const double input : wanted.inputs) sizes_.push_back(std::max(1.0, std::abs(input)));
  is_linear_ = looks_linear();
  if (is_linear_) make_responses_large();
}

Runs Prober::runs(std::int64_t steps) {
  Runs all{probe_.run(steps), {}, is_linear_, probe_.is_sampled()};
  for (int input = 0; input < probe_.inputs(); ++input)
    for (int place = 0; place <= all_places; ++place)
      all.changes.push_back(response(input, place, steps, all.baseline));
  return all;
}

double Prober::size(int input) const {
  constexpr double small = 1e-5;  // curvature and rounding leave 1e-10 each
  return (is_linear_ ? 1.0 : small) * sizes_[static_cast<std::size_t>(input)];
}

/// As large as what the run itself does, so that they are known to as many digits; if it is linear then, too.
void Prober::make_responses_large() {
  constexpr double most = 1e9;
  const auto before = sizes_;
  const MatrixXd from = probe_.run(wanted_.steps);
  for (int input = 0; input < probe_.inputs(); ++input) {
    const Change change{input, throughout, size(input)};
    const double moved = (probe_.run(wanted_.steps, &change) - from).norm();
    if (moved > 0.0) sizes_[static_cast<std::size_t>(input)] *= std::clamp(from.norm() / moved, 1.0, most);
  }
  if (!looks_linear()) sizes_ = before;
}

/// By a change of 1. What rounding has left of a response that is none is 0.
MatrixXd Prober::response(int input, int place, std::int64_t steps, const MatrixXd& baseline) {
  constexpr double rounding = 1e-13;
  const double by = size(input);
  const Change up{input, place, by}, down{input, place, -by};
  const MatrixXd moved = is_linear_
                             ? MatrixXd((probe_.run(steps, &up) - baseline) / by)
                             : MatrixXd((probe_.run(steps, &up) - probe_.run(steps, &down)) / (2.0 * by));
  return moved.norm() * by <= rounding * baseline.norm() ? MatrixXd::Zero(moved.rows(), moved.cols()) : moved;
}

bool Prober::looks_linear() {
  constexpr double tolerance = 1e-10, rounding = 1e-13;  // of a thousand steps
  const MatrixXd from = probe_.run(wanted_.steps);
  for (int input = 0; input < probe_.inputs(); ++input) {
    const Change whole{input, throughout, size(input)}, half{input, throughout, 0.5 * size(input)};
    const MatrixXd all = probe_.run(wanted_.steps, &whole) - from,
                   part = probe_.run(wanted_.steps, &half) - from;
    if ((all - 2.0 * part).norm() > tolerance * all.norm() + rounding * from.norm()) return false;
  }
  return true;
}

}  // namespace tandem::identification
