// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "kart/monolithic.hpp"
#include "kart/plane.hpp"
#include "tandem/time_series.hpp"

namespace tandem::test {

/// The torque on the driven shaft of the printed level ii over its manoeuvre.
inline const std::function<double(double)>& kart_torque() {
  static const std::function<double(double)> function = [] {
    kart::Plane kart(kart::KartData{}, kart::TyreLaw::magic_formula);
    const auto run = kart::run_monolithic(kart, 1e-4);
    std::vector<double> times, values;
    for (const auto& row : run.rows) times.push_back(row.time), values.push_back(row.torque);
    return
        [data = TimeSeries("torque", times, values, {TimeSeries::Between::linear, TimeSeries::Beyond::hold})](
            double t) { return data.value(t); };
  }();
  return function;
}

}  // namespace tandem::test
