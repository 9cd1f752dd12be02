// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mass 2 of the two-mass test in C++20, as a shared library: tandem/fixed_step.hpp does the grid, landing,
// saved states (also as bytes) and samples; tandem/c_table.hpp makes the C table.
//   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
// Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one.
#include <algorithm>
#include <array>

#include "tandem/c_table.hpp"
#include "tandem/fixed_step.hpp"

namespace {

constexpr tandem_parameter parameters[] = {{"m", "kg", nullptr, "mass"},
                                           {"k", "N/m", nullptr, "stiffness of the spring to mass 1"},
                                           {"s", "N/m", nullptr, "stiffness of both springs together"},
                                           {"x", "m", nullptr, "position at the start"},
                                           {"v", "m/s", nullptr, "speed at the start"},
                                           {"h", "s", nullptr, "own step"}};

class Mass2 {
 public:
  explicit Mass2(const tandem::ParameterValues& p)
      : m_(p.number("m")),
        k_(p.number("k")),
        s_(p.number("s")),
        x_start_(p.number("x")),
        v_start_(p.number("v")),
        h_(p.number("h")) {}

  tandem::SubsystemInfo info() const {
    return {"mass2", {{"x1", "m"}}, {{"x2", "m", 1, 2}, {"v2", "m/s", 1, 1}}, {}, {.serializes_state = true}};
  }
  double own_step() const { return h_; }

  void start(double, std::span<const double> u0) {
    x_ = x_start_;
    v_ = v_start_;
    a_ = (k_ * u0[0] - s_ * x_) / m_;
  }

  void step(const tandem::OwnStep& own, std::span<const tandem::Signal> u) {
    const double h = own.length, before = (k_ * u[0].value(own.begin) - s_ * x_) / m_;
    const double push = k_ * u[0].value(own.end);
    x_ = (x_ + h * v_ + 0.25 * h * h * (before + push / m_)) / (1.0 + 0.25 * h * h * s_ / m_);
    a_ = (push - s_ * x_) / m_;
    v_ += 0.5 * h * (before + a_);
  }

  void outputs(double* y) const {
    const double row[] = {x_, v_, v_, a_, a_, 0.0};
    std::copy(std::begin(row), std::end(row), y);
  }

  void write(tandem::ByteWriter& to) const { to.put_doubles(std::array{x_, v_, a_}); }
  void read(tandem::ByteReader& from) {
    x_ = from.take<double>();
    v_ = from.take<double>();
    a_ = from.take<double>();
  }

 private:
  double m_, k_, s_, x_start_, v_start_, h_;
  double x_ = 0.0, v_ = 0.0, a_ = 0.0;
};

std::unique_ptr<tandem::Subsystem> make(const tandem::ParameterValues& p) {
  return std::make_unique<tandem::FixedStep<Mass2>>(Mass2(p));
}

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make, parameters>(); }
