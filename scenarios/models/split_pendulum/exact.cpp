// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tandem/fixed_step.hpp"

namespace tandem::split_pendulum {
namespace {

constexpr double gravity = 9.81, upper_mass = 1.0, upper_length = 1.0;

using Angles = std::array<double, 4>;  ///< a, b, a', b'

/// The model of a FixedStep.
class Exact {
 public:
  Exact(double mass, double length, double step) : mass_(mass), length_(length), step_(step) {}

  SubsystemInfo info() const {
    return {"split_pendulum.exact", {}, {{"x", "m", 1, 1}, {"y", "m", 1, 1}}, {}, {.serializes_state = true}};
  }
  double own_step() const { return step_; }
  void start(double, std::span<const double>) {
    at_ = {std::numbers::pi / 2, std::numbers::pi / 2, 0.0, 0.0};
  }
  void step(const OwnStep& s, std::span<const Signal>) {
    const double h = s.length;
    const Angles k1 = rates(at_), k2 = rates(moved(at_, h / 2, k1)), k3 = rates(moved(at_, h / 2, k2)),
                 k4 = rates(moved(at_, h, k3));
    at_ = moved(moved(moved(moved(at_, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  void outputs(double* y) const {
    y[0] = upper_length * std::sin(at_[0]), y[1] = -upper_length * std::cos(at_[0]);
    y[2] = -y[1] * at_[2], y[3] = y[0] * at_[2];
  }
  void write(ByteWriter& to) const { to.put_doubles(at_); }
  void read(ByteReader& from) {
    for (double& angle : at_) angle = from.take<double>();
  }

 private:
  Angles rates(const Angles& y) const {
    const double m = mass_, c = 0.5 * m * upper_length * length_, cosine = c * std::cos(y[0] - y[1]),
                 sine = c * std::sin(y[0] - y[1]),
                 first = (upper_mass / 3.0 + m) * upper_length * upper_length,
                 second = m * length_ * length_ / 3.0,
                 f = -sine * y[3] * y[3] - (0.5 * upper_mass + m) * gravity * upper_length * std::sin(y[0]),
                 g = sine * y[2] * y[2] - 0.5 * m * gravity * length_ * std::sin(y[1]),
                 determinant = first * second - cosine * cosine;
    return {y[2], y[3], (f * second - g * cosine) / determinant, (first * g - cosine * f) / determinant};
  }
  static Angles moved(Angles y, double by, const Angles& rate) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += by * rate[i];
    return y;
  }

  double mass_, length_, step_;
  Angles at_{};
};

}  // namespace

void add_builtins(Builtins& builtins) {
  builtins.models["split_pendulum.exact"] = {
      words_by(Setter::client, {"lower_mass", "lower_length", "step"}),
      [](const Address&, Parameters& p) -> std::unique_ptr<Subsystem> {
        return std::make_unique<FixedStep<Exact>>(
            Exact(p.number("lower_mass", 0.1), p.number("lower_length", 0.5), p.number("step", 2.5e-4)));
      }};
}

}  // namespace tandem::split_pendulum
