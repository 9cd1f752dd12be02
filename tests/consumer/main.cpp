// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A program outside tandem's tree: two bodies exchange heat, each with its own step.
#include <cmath>
#include <cstdio>

#include "tandem/coordinator/coordinator.hpp"

namespace {

/// T' = (u - T) / 1 s, classical Runge-Kutta. Input: the other body's temperature [K]. Output: its own.
class Body : public tandem::Subsystem {
 public:
  Body(const char* name, double step, double start) : step_(step), start_(start) {
    info_ = {name, {{"surroundings", "K"}}, {{"temperature", "K"}}, {}, {.lands = true, .restarts = true}};
  }

  const tandem::SubsystemInfo& info() const override { return info_; }

  tandem::Clock initialize(double t_start, double, std::span<const double>, tandem::Samples& y) override {
    grid_ = tandem::TimeGrid(t_start, step_);
    temperature_ = start_;
    y.append(t_start)[0] = temperature_;
    return clock(tandem::Stop::limit);
  }

  tandem::Clock advance(double t_limit, bool land, std::span<const tandem::Signal> u,
                        tandem::Samples& y) override {
    while (!y.full() && grid_.fits(t_limit)) {
      integrate(grid_.length(), u[0]);
      grid_.step();
      y.append(grid_.time())[0] = temperature_;
    }
    if (land && !y.full() && grid_.cuts(t_limit)) {
      integrate(t_limit - grid_.time(), u[0]);
      grid_.cut(t_limit);
      y.append(t_limit)[0] = temperature_;
    }
    const bool more = grid_.fits(t_limit) || (land && grid_.cuts(t_limit));
    return clock(more ? tandem::Stop::samples_full : tandem::Stop::limit);
  }

  double temperature() const { return temperature_; }

 private:
  tandem::Clock clock(tandem::Stop stop) const { return {grid_.time(), grid_.next(), stop}; }

  void integrate(double h, const tandem::Signal& u) {
    const double t = grid_.time(), x = temperature_;
    const double k1 = u.value(t) - x;
    const double k2 = u.value(t + h / 2) - (x + h / 2 * k1);
    const double k3 = u.value(t + h / 2) - (x + h / 2 * k2);
    const double k4 = u.value(t + h) - (x + h * k3);
    temperature_ = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }

  tandem::SubsystemInfo info_;
  double step_, start_;
  tandem::TimeGrid grid_;
  double temperature_ = 0.0;
};

}  // namespace

int main() {
  Body hot("hot", 0.01, 400.0), cold("cold", 0.0031, 300.0);

  tandem::Topology topology;
  topology.add("hot", hot.info());
  topology.add("cold", cold.info());
  const auto cubic = tandem::Reconstruction::parse("lagrange3");
  topology.connect({.from = "hot.temperature", .to = "cold.surroundings", .how = cubic});
  topology.connect({.from = "cold.temperature", .to = "hot.surroundings", .how = cubic});
  topology.check();

  tandem::Coordinator(topology, {&hot, &cold}, {}, {0.0, 1.0}).run();

  // The sum stays 700 K, the difference decays with exp(-2 t). The scheme is of order 4, so the error is of
  // the size of h^4 d4T/dt4 = (0.01 s)^4 800 K/s^4.
  const double exact = 350.0 + 50.0 * std::exp(-2.0);
  const double error = std::abs(hot.temperature() - exact);
  std::printf("hot body after 1 s: %.9f K, error %.1e K\n", hot.temperature(), error);
  return error < 8e-6 ? 0 : 1;
}
