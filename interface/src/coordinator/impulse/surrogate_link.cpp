// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "surrogate_link.hpp"

namespace tandem {

SurrogateLink::SurrogateLink(ForceWindow window, double position, double velocity, double g)
    : y_(position),
      v_(velocity),
      at_(position),
      rate_(velocity),
      g_(g),
      from_position_(position),
      window_(window) {}

void SurrogateLink::step(double h, const double (&f)[3], const double (&a)[4]) {
  before_sum_ = sum_position_, before_position_ = y_, before_velocity_ = v_;
  forces_.step(h, f);
  sum_position_ += h * (y_ + h * (v_ / 2.0 + h * (a[0] + a[1]) / 12.0));
  y_ += h * (v_ + h * (a[0] + a[1] + a[2]) / 6.0);
  v_ += h * (a[0] + 2.0 * (a[1] + a[2]) + a[3]) / 6.0;
}

void SurrogateLink::get_states(double* z) const {
  const ForceIntegrals& of = forces_.now();
  for (const double one : {of.first, of.second, of.third, y_, v_, sum_position_}) *z++ = one;
}

void SurrogateLink::go_to(const double* z) {
  before_sum_ = sum_position_, before_position_ = y_, before_velocity_ = v_;
  forces_.go_to({z[force_first], z[force_second], z[force_third]});
  y_ = z[at], v_ = z[rate_of], sum_position_ = z[position_sum];
}

void SurrogateLink::make_up_start(int steps, double h, double missed, double reaction) {
  const ForceIntegrals of = missed_at_start(steps, h);
  forces_.add({of.first * missed, of.second * missed, of.third * missed});
  y_ += of.second * reaction, v_ += of.first * reaction;
}

ForceIntegrals SurrogateLink::cut_at_node(double h, double s, double force_before, double force_now,
                                          double length) {
  const ForceIntegrals node = forces_.cut_at_node(h, s, force_before, force_now);
  const double x = (h - s) / h;
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
  const DefectPulse defect(position - foreseen_, velocity - foreseen_rate_, next);
  if (jumps)
    y_ += defect.free(s), v_ += defect.free_rate(), from_position_ += defect.free(0.0);
  else
    pulse_.turn_to(defect, s, y_, v_);
  follow(rest(velocity, reaction, length), s, length);
  at_ = position, rate_ = velocity, length_ = length;
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

std::vector<double*> SurrogateLink::own_numbers() {
  return {&y_,
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
          &mean_velocity_};
}

std::vector<double*> SurrogateLink::numbers() {
  std::vector<double*> all = own_numbers();
  for (double* one : forces_.numbers()) all.push_back(one);
  for (double* one : pulse_.numbers()) all.push_back(one);
  for (double* one : window_.numbers()) all.push_back(one);
  return all;
}

void SurrogateLink::begin_at_node(double acceleration, double length) {
  foreseen_ = y_, foreseen_rate_ = v_, mean_position_ = y_, mean_velocity_ = v_;
  rate_ = v_ - length * acceleration, g_mean_ = g_;
}

void SurrogateLink::write(ByteWriter& to) const {
  SurrogateLink copy = *this;
  for (const double* one : copy.own_numbers()) to.put(*one);
  to.put(length_), forces_.write(to), pulse_.write(to), window_.write(to);
}

void SurrogateLink::read(ByteReader& from) {
  for (double* one : own_numbers()) *one = from.take<double>();
  length_ = from.take<double>(), forces_.read(from), pulse_.read(from), window_.read(from);
}

}  // namespace tandem
