// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scripted.hpp"
#include "tandem/coordinator/recorder.hpp"

namespace tandem::test {

inline double cubic_of_time(double t) { return 1.0 - 2.0 * t + 0.5 * t * t * t; }
inline double slope(double t) { return -2.0 + 1.5 * t * t; }
inline double line(double t) { return 3.0 - 7.0 * t; }

/// Outputs: "c", a cubic with its derivative; "l", a straight line without; "a", an array of two.
inline Scripted shapes(double own_step) {
  SubsystemInfo info{"shapes", {}, {{"c", "m", 1, 1}, {"l", "N"}, {"a", "1", 2}}, {}, {}};
  return {info, own_step, [](double t, const std::vector<double>&, double* y) {
            const double row[] = {cubic_of_time(t), line(t), 2.0 * t, std::sin(t), slope(t), 0.0, 0.0, 0.0};
            std::copy(std::begin(row), std::end(row), y);
          }};
}

/// A run of shapes, one for each own step, named "a", "b", ... and not connected.
struct RecorderBench {
  explicit RecorderBench(const std::vector<double>& own_steps, double t_stop = 2.0,
                         const Coordination& coordination = {}) {
    for (const double h : own_steps) subsystems.push_back(std::make_unique<Scripted>(shapes(h)));
    std::vector<Subsystem*> all;
    for (std::size_t i = 0; i < subsystems.size(); ++i) {
      topology.add(std::string(1, static_cast<char>('a' + i)), subsystems[i]->info());
      all.push_back(subsystems[i].get());
    }
    run.emplace(topology, all, coordination, TimeSpan{0.0, t_stop});
  }

  /// Runs and closes; the recorder as it is then.
  std::unique_ptr<Recorder> record(tandem::Recording what) {
    auto recorder = std::make_unique<Recorder>(*run, std::move(what));
    run->observe(recorder.get());
    run->run();
    recorder->close();
    return recorder;
  }

  std::vector<std::unique_ptr<Scripted>> subsystems;
  Topology topology;
  std::optional<Coordinator> run;
};

}  // namespace tandem::test
