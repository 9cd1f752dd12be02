// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "prober.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem::identification {

using Eigen::MatrixXd;

Runs Runs::up_to(std::int64_t steps) const {
  Runs all{baseline.leftCols(steps + 1), {}, linear, sampled};
  for (const MatrixXd& change : changes) all.changes.push_back(change.leftCols(steps + 1));
  return all;
}

Prober::Prober(Subsystem& subsystem, const Wanted& wanted)
    : probe_(subsystem, wanted),
      wanted_(wanted),
      look_(std::min(2 * wanted.steps, most_steps)),
      baseline_(probe_.run(look_)) {
  for (const double input : wanted.inputs) sizes_.push_back(std::max(1.0, std::abs(input)));
  is_linear_ = looks_linear() || (is_nearly_linear_ && looks_linear_by_more());
}

Runs Prober::runs(std::int64_t steps) {
  make_responses_large();
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

void Prober::make_responses_large() {
  if (!is_linear_ || std::exchange(are_large_, true)) return;
  constexpr double most = 1e9;
  const auto before = sizes_;
  for (std::size_t k = 0; k < sizes_.size(); ++k)
    if (const double moved = moved_[k].norm(); moved > 0.0)
      sizes_[k] *= std::clamp(baseline_.norm() / moved, 1.0, most);
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

/// What a solver's iterations leave is alike whatever the change is, and what is curved grows with it.
bool Prober::looks_linear_by_more() {
  constexpr double more = 1e3;
  const auto before = sizes_;
  for (double& size : sizes_) size *= more;
  if (looks_linear()) return true;
  sizes_ = before;
  return false;
}

bool Prober::looks_linear() {
  constexpr double tolerance = 1e-10, rounding = 1e-13;  // of a thousand steps
  constexpr double nearly = 1e-7;
  moved_.clear();
  for (int input = 0; input < probe_.inputs(); ++input) {
    const Change whole{input, throughout, size(input)}, half{input, throughout, 0.5 * size(input)};
    MatrixXd all = probe_.run(look_, &whole) - baseline_;
    const MatrixXd part = probe_.run(look_, &half) - baseline_;
    const double off = (all - 2.0 * part).norm();
    is_nearly_linear_ = off <= nearly * all.norm();
    if (off > tolerance * all.norm() + rounding * baseline_.norm()) return false;
    moved_.push_back(std::move(all));
  }
  return true;
}

}  // namespace tandem::identification
