// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "surrogate_link.hpp"

namespace tandem {
namespace {

/// A cubic through two values with their rates, at x of a step h long, 0 <= x <= 1.
double hermite(double h, double x, double y0, double d0, double y1, double d1) {
  const double u = 1.0 - x;
  return u * u * ((1.0 + 2.0 * x) * y0 + x * h * d0) + x * x * ((1.0 + 2.0 * u) * y1 - u * h * d1);
}

}  // namespace

SurrogateLink::SurrogateLink(ForceWindow window, double position, double velocity, double g)
    : y_(position),
      v_(velocity),
      at_(position),
      rate_(velocity),
      g_(g),
      from_position_(position),
      window_(window) {}

void SurrogateLink::step(double h, const double (&f)[3], const double (&a)[4]) {
  before_ = sum_, before_sum_ = sum_position_, before_position_ = y_, before_velocity_ = v_;
  sum_.third += h * (before_.second + h * (before_.first / 2.0 + h * (f[0] + f[1]) / 12.0));
  sum_.second += h * (before_.first + h * (f[0] + 2.0 * f[1]) / 6.0);
  sum_.first += h * (f[0] + 4.0 * f[1] + f[2]) / 6.0;
  sum_position_ += h * (y_ + h * (v_ / 2.0 + h * (a[0] + a[1]) / 12.0));
  y_ += h * (v_ + h * (a[0] + a[1] + a[2]) / 6.0);
  v_ += h * (a[0] + 2.0 * (a[1] + a[2]) + a[3]) / 6.0;
}

/// The polynomials of steps n and n + 1 differ by binomial(t / h, n) times what was missed; its integrals from 0 to n.
void SurrogateLink::make_up_start(int steps, double h, double missed, double reaction) {
  constexpr ForceIntegrals of[] = {{1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0},
                                   {1.0 / 3.0, 0.0, -1.0 / 15.0},
                                   {3.0 / 8.0, 3.0 / 20.0, 9.0 / 80.0},
                                   {14.0 / 45.0, 0.0, -8.0 / 63.0}};
  const ForceIntegrals& one = of[steps - 1];
  sum_.third += h * h * h * one.third * missed;
  sum_.second += h * h * one.second * missed;
  sum_.first += h * one.first * missed;
  y_ += h * h * one.second * reaction;
  v_ += h * one.first * reaction;
}

ForceIntegrals SurrogateLink::cut_at_node(double h, double s, double force_before, double force_now,
                                          double length) {
  const double x = (h - s) / h;
  const ForceIntegrals node{hermite(h, x, before_.first, force_before, sum_.first, force_now),
                            hermite(h, x, before_.second, before_.first, sum_.second, sum_.first),
                            hermite(h, x, before_.third, before_.second, sum_.third, sum_.second)};
  sum_.third -= node.third + s * (node.second + s * node.first / 2.0);
  sum_.second -= node.second + s * node.first;
  sum_.first -= node.first;
  const double position = hermite(h, x, before_position_, before_velocity_, y_, v_);
  const double all = hermite(h, x, before_sum_, before_position_, sum_position_, y_);
  mean_position_ = all / length, mean_velocity_ = (position - from_position_) / length;
  sum_position_ -= all, from_position_ = position;
  return node;
}

void SurrogateLink::foresee(double reaction, double length) {
  const double a = reaction + g_ + g_rate_ * length / 2.0;
  foreseen_rate_ = rate_ + length * a;
  foreseen_ = at_ + length * (rate_ + length * a / 2.0);
}

/// Of what is a parabola with these ends and this acceleration.
double SurrogateLink::foreseen_mean(double acceleration, double length) const {
  return (at_ + foreseen_) / 2.0 - length * length * acceleration / 12.0;
}

void SurrogateLink::take(double position, double velocity, double reaction, double s, double length,
                         double next, bool jumps) {
  put_in({position - foreseen_, velocity - foreseen_rate_, next}, s, length, jumps);
  follow((velocity - rate_) / length - reaction, s, length);
  at_ = position, rate_ = velocity, length_ = length;
}

/// The last pulse, which went on past its end, goes over into the free motion of its defect.
void SurrogateLink::put_in(const DefectPulse& pulse, double s, double length, bool jumps) {
  if (jumps) {
    y_ += pulse.free(s), v_ += pulse.free_rate(), from_position_ += pulse.free(0.0);
    return;
  }
  const double end = length + s;
  y_ += pulse.value(s) - (pulse_.value(end) - pulse_.free(end));
  v_ += pulse.rate(s) - (pulse_.rate(end) - pulse_.free_rate());
  pulse_ = pulse;
}

/// What remains of the acceleration is a straight line through its means over two steps; the change since the node is
/// made up for.
void SurrogateLink::follow(double g_mean, double s, double length) {
  const double rate =
      length_ > 0.0 ? (g_mean - g_mean_) / (0.5 * (length + length_)) : (g_mean - g_) / (0.5 * length);
  const double g = g_mean + rate * length / 2.0;
  const double change = g - g_ - g_rate_ * length;
  make_up(s, change, change + s * (rate - g_rate_));
  g_ = g, g_rate_ = rate, g_mean_ = g_mean;
}

void SurrogateLink::make_up(double s, double then, double now) {
  v_ += s * (then + now) / 2.0;
  y_ += s * s * (2.0 * then + now) / 6.0;
}

/// All numbers of its own.
std::vector<double*> SurrogateLink::numbers() {
  return {&sum_.first,
          &sum_.second,
          &sum_.third,
          &before_.first,
          &before_.second,
          &before_.third,
          &y_,
          &v_,
          &at_,
          &rate_,
          &g_,
          &g_rate_,
          &g_mean_,
          &foreseen_,
          &foreseen_rate_,
          &mean_force_,
          &sum_position_,
          &before_sum_,
          &before_position_,
          &before_velocity_,
          &from_position_,
          &mean_position_,
          &mean_velocity_,
          &length_};
}

void SurrogateLink::write(ByteWriter& to) const {
  SurrogateLink copy = *this;
  for (const double* one : copy.numbers()) to.put(*one);
  pulse_.write(to), window_.write(to);
}

void SurrogateLink::read(ByteReader& from) {
  for (double* one : numbers()) *one = from.take<double>();
  pulse_.read(from), window_.read(from);
}

}  // namespace tandem
