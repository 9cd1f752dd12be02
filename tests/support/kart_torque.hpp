// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "engine_files.hpp"
#include "tandem/time_series.hpp"

namespace tandem::test {

/// The kart of level ii with its power train as one diagram, every 0.1 ms of its manoeuvre of 10 s.
struct KartManoeuvre {
  std::vector<double> times, torque, pitch;  ///< [s], on the driven shaft [N m], [deg]
};
inline const KartManoeuvre& kart_manoeuvre() {
  static const KartManoeuvre manoeuvre = [] {
    EngineRun run(engine_file("kart_monolithic.toml"));
    KartManoeuvre all;
    for (int k = 0; k <= 100000; ++k) {
      run.run(1e-4 * k, 1e-4);
      all.times.push_back(1e-4 * k);
      all.torque.push_back(run["torque"]), all.pitch.push_back(run["pitch"]);
    }
    return all;
  }();
  return manoeuvre;
}

/// Its torque.
inline const std::function<double(double)>& kart_torque() {
  static const std::function<double(double)> function =
      [data = TimeSeries("torque", kart_manoeuvre().times, kart_manoeuvre().torque,
                         {TimeSeries::Between::linear, TimeSeries::Beyond::hold})](double t) {
        return data.value(t);
      };
  return function;
}

}  // namespace tandem::test
