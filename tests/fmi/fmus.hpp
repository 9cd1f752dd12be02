// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tandem/fmi/fmi.hpp"

namespace tandem::test {

inline Builtins fmu_sources(const std::function<void(const std::string&)>& tell = {}) {
  Builtins builtins;
  add_fmi(builtins, tell);
  return builtins;
}

/// An FMU of tests/libraries/fmi with its parameters: "decay?step=0.1".
inline std::string fmu_uri(const std::string& name) {
  const auto mark = std::min(name.find('?'), name.size());
  return "fmu:" TANDEM_FMUS "/" + name.substr(0, mark) + ".fmu" + name.substr(mark);
}
inline std::unique_ptr<Subsystem> open_fmu(const std::string& name) {
  return open(fmu_uri(name), fmu_sources());
}

/// Inputs that are constant but for one, which jumps at `time` to `value`.
struct JumpingInputs {
  JumpingInputs(const std::vector<double>& u0, std::size_t which, double time, double value, double t_stop) {
    for (const double u : u0) pieces.push_back({{t_stop, 0.0, {u}}});
    pieces[which] = {{time, 0.0, {u0[which]}}, {t_stop, time, {value}}};
    mark_jump(pieces[which][1], true);
    for (const auto& p : pieces) signals.emplace_back(p.data(), static_cast<std::int32_t>(p.size()), 0);
  }
  JumpingInputs(const JumpingInputs&) = delete;
  JumpingInputs& operator=(const JumpingInputs&) = delete;

  std::vector<std::vector<Segment>> pieces;
  std::vector<Signal> signals;
};

/// A run of one FMU on constant inputs; its rows from the start on: time, jump flag, outputs.
struct FmuRun {
  std::vector<std::vector<double>> rows;
  Clock clock{};

  FmuRun(Subsystem& fmu, double t_stop, std::vector<double> inputs = {}) {
    const auto stride = fmu.info().row_size();
    std::vector<double> memory(static_cast<std::size_t>(stride) * 50);
    std::vector<Segment> segments(inputs.size());
    std::vector<Signal> signals;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      segments[k] = {t_stop, 0.0, {inputs[k]}};
      signals.emplace_back(&segments[k], 1, 0);
    }
    Samples first(memory.data(), stride, 1);
    clock = fmu.initialize(0.0, t_stop, inputs, first);
    keep(first);
    do {
      Samples y(memory.data(), stride, 50);
      clock = fmu.advance(t_stop, false, signals, y);
      keep(y);
    } while (clock.stop == Stop::samples_full || clock.stop == Stop::event);
  }

 private:
  void keep(const Samples& y) {
    for (std::int64_t k = 0; k < y.size(); ++k) {
      rows.push_back({y.time(k), y.jump(k) ? 1.0 : 0.0});
      rows.back().insert(rows.back().end(), y.values(k).begin(), y.values(k).end());
    }
  }
};

/// x of x'' = (1 - x^2) x' - x from (2, 0), to the last digit of a double up to 20 s: Richardson's extrapolation of the
/// classical method in long double, whose runs differ by 2e-13.
inline double van_der_pol_at(double time) {
  using State = std::array<long double, 2>;
  const auto at = [time](int steps) {
    const long double h = time / static_cast<long double>(steps);
    State y{2.0L, 0.0L};
    const auto stage = [&](const State& k, long double part) {
      const State z{y[0] + part * h * k[0], y[1] + part * h * k[1]};
      return State{z[1], (1.0L - z[0] * z[0]) * z[1] - z[0]};
    };
    for (int n = 0; n < steps; ++n) {
      const State a = stage({}, 0.0L), b = stage(a, 0.5L), c = stage(b, 0.5L), d = stage(c, 1.0L);
      for (std::size_t i = 0; i < 2; ++i) y[i] += h / 6.0L * (a[i] + 2.0L * (b[i] + c[i]) + d[i]);
    }
    return y[0];
  };
  const long double coarse = at(20000), fine = at(40000);
  return static_cast<double>(fine + (fine - coarse) / 15.0L);
}

/// By how much bounces of a ball are off in time [s] that falls from 1 m and leaves with 0.7 of its speed;
/// infinite for fewer than six.
inline double error_of_bounces(const std::vector<std::vector<double>>& rows) {
  double t = std::sqrt(2.0 / 9.81), flight = 2.0 * t, largest = 0.0;
  int count = 0;
  for (const auto& row : rows) {
    if (row[1] != 1.0) continue;
    largest = std::max(largest, std::abs(row[0] - t));
    t += flight *= 0.7, ++count;
  }
  return count < 6 ? std::numeric_limits<double>::infinity() : largest;
}

}  // namespace tandem::test
