// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem::fuzz {

/// x' = u with steps of 0.1 s, up to eight in a call, or x = u where it is asked to sample; saves one state. Its input may
/// react, if it is to.
class Sum final : public Subsystem {
 public:
  explicit Sum(bool reacts = false) { info_.abilities.reactive_inputs = reacts; }
  const SubsystemInfo& info() const override { return info_; }

  Clock initialize(double t_start, double, std::span<const double>, Samples& y) override {
    time_ = t_start;
    y.append(time_)[0] = x_ = 0.0;
    return {time_, time_ + h, Stop::limit};
  }
  Clock advance(double t_limit, bool, std::span<const Signal> u, Samples& y) override {
    const Reaction* const r = reaction_of(u);
    std::vector<double> z, rates;
    if (r) z.assign(r->begin, r->begin + r->states), rates.resize(z.size());
    for (int k = 0; k < 8 && time_ + h <= t_limit && !y.full(); ++k) {
      if (r) tandem_reaction_rates(r, time_, z.data(), &x_, rates.data());
      x_ += h * u[0].value(time_, z.data());
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += h * rates[i];
      double* const row = y.append(time_ += h);
      row[0] = x_, std::copy(z.begin(), z.end(), row + 1);
    }
    return {time_, time_ + h, time_ + h <= t_limit ? Stop::samples_full : Stop::limit};
  }
  Clock sample(double t, SamplePart, std::span<const double> u, std::span<double> y) override {
    time_ = t, x_ = u[0];
    if (!y.empty()) y[0] = x_;
    return {time_, time_ + h, Stop::limit};
  }
  StateId save_state() override {
    saved_ = {time_, x_};
    return 1;
  }
  Clock restore_state(StateId) override {
    time_ = saved_.time, x_ = saved_.x;
    return {time_, time_ + h, Stop::limit};
  }
  void release_state(StateId) override {}

 private:
  static constexpr double h = 0.1;  // s
  struct State {
    double time = 0.0, x = 0.0;
  };
  SubsystemInfo info_{"sum", {{"u", "1"}}, {{"x", "1"}}, {}, {.saves_state = true}};
  double time_ = 0.0, x_ = 0.0;
  State saved_;
};

}  // namespace tandem::fuzz
