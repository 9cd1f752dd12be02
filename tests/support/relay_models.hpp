// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A relay with a lag behind it in one subsystem and its plant in another.
//   plant   x' = v,  v' = -w^2 x - 2 d w v + gain_r r + gain_y y
//   relay   r jumps from 1 to -1 where x rises above `width`, and back where it falls below -width;
//           z' = -k z + x + r,  y = z + jump r
#pragma once
#include <algorithm>
#include <span>

#include "exact_pieces.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::test {

struct RelaySystem {
  double w = 5.0, d = 0.1, gain_r = 10.0, gain_y = 0.0;
  double width = 0.1, k = 2.0, jump = 0.0;
};

/// For FixedStep: exact under its piecewise polynomial input, by its power series.
class Relay {
 public:
  Relay(const RelaySystem& system, double h) : s_(system), h_(h) {}

  SubsystemInfo info() const {
    SubsystemInfo info{"relay", {{"x", "m"}}, {{"r", "1"}, {"y", "1"}}, {}, {}};
    info.outputs[0].held = true;
    info.abilities.events = info.abilities.serializes_state = true;
    return info;
  }
  double own_step() const { return h_; }
  void start(double, std::span<const double>) { r_ = before_ = 1.0, z_ = 0.0; }

  bool step_to_event(OwnStep& s, std::span<const Signal> u) {
    const double end = s.end;
    const bool event = beyond(u[0].value(end));
    if (event) s.end = find(u[0], s.begin, end);
    for_each_piece(u[0], s, [&](const Segment& p, double from, double to) { propagate(p, from, to); });
    before_ = r_;
    if (event) r_ = -r_;
    return event;
  }
  void outputs(double* y) const { y[0] = r_, y[1] = z_ + s_.jump * r_; }
  void outputs_before(double* y) const { y[0] = before_, y[1] = z_ + s_.jump * before_; }
  void write(ByteWriter& to) const {
    for (const double v : {r_, before_, z_}) to.put(v);
  }
  void read(ByteReader& from) {
    for (double* v : {&r_, &before_, &z_}) *v = from.take<double>();
  }

 private:
  bool beyond(double x) const { return r_ > 0.0 ? x > s_.width : x < -s_.width; }
  double find(const Signal& u, double low, double high) const {
    while (true) {
      const double middle = low + (high - low) / 2.0;
      if (middle <= low || middle >= high) return high;
      (beyond(u.value(middle)) ? high : low) = middle;
    }
  }
  void propagate(const Segment& piece, double from, double to) {
    constexpr int terms = 26;
    const auto u = shifted(piece, from);
    double c[terms] = {z_};
    for (int n = 0; n + 1 < terms; ++n)
      c[n + 1] = ((n < TANDEM_MAX_COEFFICIENTS ? u[static_cast<std::size_t>(n)] : 0.0) + (n == 0 ? r_ : 0.0) -
                  s_.k * c[n]) /
                 (n + 1);
    z_ = 0.0;
    for (int n = terms - 1; n >= 0; --n) z_ = z_ * (to - from) + c[n];
  }

  RelaySystem s_;
  double h_, r_ = 1.0, before_ = 1.0, z_ = 0.0;
};

/// One that locates its switchings within its steps, and gives its outputs at their ends alone.
class QuietRelay : public Relay {
 public:
  using Relay::Relay;
  SubsystemInfo info() const {
    SubsystemInfo info = Relay::info();
    info.abilities.events = false;
    return info;
  }
  void step(const OwnStep& s, std::span<const Signal> u) {
    OwnStep part = s;
    while (step_to_event(part, u)) part = {part.end, s.end, s.end - part.end};
  }

 private:
  using Relay::outputs_before, Relay::step_to_event;
};

/// For FixedStep: exact likewise. Inputs r and y.
class RelayPlant {
 public:
  RelayPlant(const RelaySystem& system, double h) : s_(system), h_(h) {}
  SubsystemInfo info() const {
    return {"plant", {{"r", "1"}, {"y", "1"}}, {{"x", "m"}, {"v", "m/s"}}, {}, {.serializes_state = true}};
  }
  double own_step() const { return h_; }
  void start(double, std::span<const double>) { x_ = 0.0, v_ = 0.0; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    double from = s.begin;
    while (from < s.end) {
      const Segment &r = at(u[0], from), &y = at(u[1], from);
      const double to = std::min({r.end > from ? r.end : s.end, y.end > from ? y.end : s.end, s.end});
      propagate(r, y, from, to);
      from = to;
    }
  }
  void outputs(double* y) const { y[0] = x_, y[1] = v_; }
  void write(ByteWriter& to) const { to.put(x_), to.put(v_); }
  void read(ByteReader& from) { x_ = from.take<double>(), v_ = from.take<double>(); }

 private:
  /// The piece that holds after t.
  static const Segment& at(const Signal& u, double t) {
    for (const Segment& s : u.segments())
      if (s.end > t) return s;
    return u.segments().back();
  }
  void propagate(const Segment& r, const Segment& y, double from, double to) {
    constexpr int terms = 26;
    const auto a = shifted(r, from), b = shifted(y, from);
    double c[terms] = {x_, v_};
    for (int n = 0; n + 2 < terms; ++n) {
      const auto m = static_cast<std::size_t>(n);
      const double f = n < TANDEM_MAX_COEFFICIENTS ? s_.gain_r * a[m] + s_.gain_y * b[m] : 0.0;
      c[n + 2] = (f - s_.w * s_.w * c[n] - 2.0 * s_.d * s_.w * (n + 1) * c[n + 1]) / ((n + 1) * (n + 2));
    }
    x_ = v_ = 0.0;
    for (int n = terms - 1; n >= 0; --n) x_ = x_ * (to - from) + c[n];
    for (int n = terms - 1; n >= 1; --n) v_ = v_ * (to - from) + n * c[n];
  }

  RelaySystem s_;
  double h_, x_ = 0.0, v_ = 0.0;
};

}  // namespace tandem::test
