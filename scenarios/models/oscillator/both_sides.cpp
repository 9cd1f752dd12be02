// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "oscillator/both_sides.hpp"

#include <unsupported/Eigen/MatrixFunctions>

namespace tandem::oscillator {

BothSides BothSides::from(Parameters& p) {
  const double m1 = positive(p, "m1", 1.0), m2 = positive(p, "m2", 1.0);
  const double c = p.number("c", 1.0), d = p.number("d", 0.0);
  const double c1 = p.number("c1", 1.0) + c, c2 = p.number("c2", 1.0) + c;
  const double d1 = p.number("d1", 0.0) + d, d2 = p.number("d2", 0.0) + d;
  Eigen::Matrix4d rates;
  rates << 0.0, 1.0, 0.0, 0.0,             //
      -c1 / m1, -d1 / m1, c / m1, d / m1,  //
      0.0, 0.0, 0.0, 1.0,                  //
      c / m2, d / m2, -c2 / m2, -d2 / m2;
  const State z(p.number("x1", 0.0), p.number("v1", 0.0), p.number("x2", 0.0), p.number("v2", 0.0));
  return {rates, z, positive(p, "step", 0.01)};
}

Words BothSides::words() {
  return words_by(Setter::client,
                  {"m1", "m2", "c", "d", "c1", "c2", "d1", "d2", "x1", "v1", "x2", "v2", "step"});
}

SubsystemInfo BothSides::info() const {
  return {"oscillator.exact",
          {},
          {{"x1", "m", 1, 2}, {"v1", "m/s", 1, 1}, {"x2", "m", 1, 2}, {"v2", "m/s", 1, 1}},
          {},
          {.serializes_state = true}};
}

void BothSides::start(double t, std::span<const double>) { t0_ = t, state_ = at_start_; }

void BothSides::step(const OwnStep& s, std::span<const Signal>) {
  state_ = (rates_ * (s.end - t0_)).exp() * at_start_;
}

void BothSides::outputs(double* y) const {
  const State v = rates_ * state_;
  const double row[] = {state_[0], state_[1], state_[2], state_[3],  //
                        v[0],      v[1],      v[2],      v[3],       //
                        v[1],      0.0,       v[3],      0.0};
  std::copy(std::begin(row), std::end(row), y);
}

void BothSides::write(ByteWriter& to) const {
  to.put(t0_);
  to.put_doubles(std::span(state_.data(), 4));
}

void BothSides::read(ByteReader& from) {
  t0_ = from.take<double>();
  for (double& value : state_) value = from.take<double>();
}

}  // namespace tandem::oscillator
