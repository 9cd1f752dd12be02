// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::test {

/// A subsystem with a fixed own step whose outputs are a given function of time and of the inputs at that
/// time. It writes down each call, and parts of it can be replaced, to break the contract.
class Scripted : public Subsystem {
 public:
  using Outputs = std::function<void(double t, const std::vector<double>& u, double* y)>;
  struct Call {
    double limit;
    bool land;
  };

  Scripted(SubsystemInfo info, double own_step, Outputs outputs)
      : info_(std::move(info)), own_step_(own_step), outputs_(std::move(outputs)) {}

  /// Replaces initialize and advance.
  std::function<Clock(double t_start, std::span<const double> u0, Samples& y)> instead_of_initialize;
  std::function<Clock(double t_limit, bool land, std::span<const Signal> u, Samples& y)> instead_of_advance;

  std::vector<Call> calls;                  ///< of advance
  std::vector<std::vector<double>> starts;  ///< u0 of each initialize

  const SubsystemInfo& info() const override { return info_; }

  Clock initialize(double t_start, double, std::span<const double> u0, Samples& y) override {
    starts.emplace_back(u0.begin(), u0.end());
    grid_ = TimeGrid(t_start, own_step_);
    if (instead_of_initialize) return instead_of_initialize(t_start, u0, y);
    outputs_(t_start, starts.back(), y.append(t_start));
    return clock(Stop::limit);
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    calls.push_back({t_limit, land});
    if (instead_of_advance) return instead_of_advance(t_limit, land, u, y);
    for (; !y.full() && grid_.fits(t_limit); put(u, y)) grid_.step();
    if (land && !y.full() && grid_.cuts(t_limit)) {
      grid_.cut(t_limit);
      put(u, y);
    }
    return clock(y.full() ? Stop::samples_full : Stop::limit);
  }

  TimeGrid& grid() { return grid_; }
  /// Appends the row of the present time.
  void put(std::span<const Signal> u, Samples& y, bool jump = false) {
    u_.clear();
    for (const Signal& s : u) u_.push_back(s.value(grid_.time()));
    outputs_(grid_.time(), u_, y.append(grid_.time(), jump));
  }
  Clock clock(Stop stop) const { return {grid_.time(), grid_.next(), stop}; }

 private:
  SubsystemInfo info_;
  double own_step_;
  Outputs outputs_;
  TimeGrid grid_;
  std::vector<double> u_;
};

/// One output "y" = f(t), no input.
template <class F>
Scripted source(double own_step, F f) {
  return {{"source", {}, {{"y", "1"}}, {}, {}},
          own_step,
          [f](double t, const std::vector<double>&, double* y) { y[0] = f(t); }};
}

/// One input "u", one output "y" that is the input (feedthrough).
inline Scripted mirror(double own_step) {
  return {{"mirror", {{"u", "1"}}, {{"y", "1"}}, {{0, 0}}, {}},
          own_step,
          [](double, const std::vector<double>& u, double* y) { y[0] = u[0]; }};
}

/// One input "u", one output "y" that is always 0 (no feedthrough): it takes part and disturbs nobody.
inline Scripted listener(double own_step) {
  return {{"listener", {{"u", "1"}}, {{"y", "1"}}, {}, {}},
          own_step,
          [](double, const std::vector<double>&, double* y) { y[0] = 0.0; }};
}

}  // namespace tandem::test
