// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
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
