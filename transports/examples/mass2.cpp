// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mass 2 of the two-mass test in C++20, as a shared library: tandem/fixed_step.hpp does the grid, landing,
// saved states (also as bytes) and samples; tandem/c_table.hpp makes the C table.
//   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
// Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one. Parameters: m [kg], k, s [N/m],
// x, v (at the start) and h [s], each of them needed.
#include <algorithm>
#include <array>

#include "tandem/c_table.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/transports/parameters.hpp"

namespace {

class Mass2 {
 public:
  explicit Mass2(tandem::Parameters& p)
      : m_(needed(p, "m")),
        k_(needed(p, "k")),
        s_(needed(p, "s")),
        x_start_(needed(p, "x")),
        v_start_(needed(p, "v")),
        h_(needed(p, "h")) {}

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
  static double needed(tandem::Parameters& p, const char* name) {
    if (!p.has(name))
      throw tandem::Error(tandem::ErrorCode::invalid_argument,
                          std::string("mass2: the parameter '") + name + "' is needed");
    return p.number(name, 0.0);
  }

  double m_, k_, s_, x_start_, v_start_, h_;
  double x_ = 0.0, v_ = 0.0, a_ = 0.0;
};

std::unique_ptr<tandem::Subsystem> make(const std::string& text) {
  tandem::Parameters parameters;
  if (!text.empty()) parameters.read(text, "mass2");
  auto subsystem = std::make_unique<tandem::FixedStep<Mass2>>(Mass2(parameters));
  parameters.refuse_unused("mass2");
  return subsystem;
}

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make>(); }
