// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/impulse/force_window.hpp"

#include "tandem/bytes.hpp"

namespace tandem {

ForceWindow::ForceWindow(Kind kind, double first_step) : kind_(kind) {
  for (Box& box : boxes_) box = {0.0, first_step};
}

double ForceWindow::pass(const ForceIntegrals& of, double length, double next) {
  const double before = rate_;
  const double moved = kind_ == Kind::hat ? hat(of, length, next) : b_spline(of, length, next);
  rate_ = moved / (0.5 * (length + next));
  const double force = (rate_ - before) / length;
  rate_ -= of.first;
  return force;
}

/// By how much X moves.
double ForceWindow::hat(const ForceIntegrals& of, double length, double next) {
  const double slope = of.second / length;
  const double moved = of.second + 0.5 * next * slope - 0.5 * length * slope_;
  slope_ = slope - of.first;
  return moved;
}

/// X = sum w_j mean_j, right where the double integral is a parabola: with tau_j the middle of step j from this node,
/// sum w = 1, sum w tau = next / 2, sum w (tau^2 + length^2 / 12) = 0.
double ForceWindow::b_spline(const ForceIntegrals& of, double length, double next) {
  boxes_[2] = boxes_[1], boxes_[1] = boxes_[0], boxes_[0] = {of.third / length, length};
  double middles[3], squares[3], end = 0.0;
  for (int j = 0; j < 3; ++j) {
    const double h = boxes_[j].length;
    middles[j] = end - 0.5 * h, squares[j] = middles[j] * middles[j] + h * h / 12.0;
    end -= h;
  }
  const double m1 = middles[1] - middles[0], m2 = middles[2] - middles[0];
  const double s1 = squares[1] - squares[0], s2 = squares[2] - squares[0];
  const double m = 0.5 * next - middles[0], s = -squares[0], determinant = m1 * s2 - m2 * s1;
  const double w1 = (m * s2 - m2 * s) / determinant, w2 = (m1 * s - m * s1) / determinant;
  const double x =
      boxes_[0].mean + w1 * (boxes_[1].mean - boxes_[0].mean) + w2 * (boxes_[2].mean - boxes_[0].mean);
  const double moved = x - middle_;
  middle_ = x - of.second - 0.5 * next * of.first;
  for (int j = 0; j < 3; ++j) boxes_[j].mean -= of.second + middles[j] * of.first;
  return moved;
}

std::array<double*, 6> ForceWindow::numbers() {
  return {&boxes_[0].mean, &boxes_[1].mean, &boxes_[2].mean, &slope_, &middle_, &rate_};
}

void ForceWindow::write(ByteWriter& to) const {
  for (const Box& box : boxes_) to.put(box.mean), to.put(box.length);
  to.put(slope_), to.put(middle_), to.put(rate_);
}

void ForceWindow::read(ByteReader& from) {
  for (Box& box : boxes_) box.mean = from.take<double>(), box.length = from.take<double>();
  for (double* one : {&slope_, &middle_, &rate_}) *one = from.take<double>();
}

}  // namespace tandem
