// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams of which one jumps and the other reads it, and both as one diagram.
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "run_bench.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"

namespace tandem::test {

/// A signal has the same name on both sides. The one that jumps gives y and reads z, the other the reverse.
struct JumpingScene {
  std::string name;
  std::string jumping, reading;
};

inline const std::vector<JumpingScene> jumping_scenes = {
    {"step",
     "s = { kind = 'step', time = 0.3137, after = 1 }\nf = { kind = 'lag', input = 'z', time = 0.3 }\n"
     "y = { kind = 'sum', inputs = ['s', 'f'], gains = [1, -0.5] }\n",
     "z = { kind = 'lag', input = 'y', time = 0.2 }\n"},
    {"reset",
     "rate = { kind = 'gain', input = 'z', gain = 2, offset = 1 }\n"
     "past = { kind = 'gain', input = 'y', gain = 1, offset = -0.3713 }\n"
     "y = { kind = 'integrator', input = 'rate', reset = 'past' }\n",
     "z = { kind = 'lag', input = 'y', time = 0.2 }\n"},
    {"bounce",
     "a = { kind = 'gain', input = 'z', gain = -3, offset = -9.81 }\n"
     "y = { kind = 'integrator', input = 'a', initial = 1, reset = 'below', reset_to = 'back' }\n"
     "back = { kind = 'gain', input = 'y', gain = -0.9 }\n"
     "x = { kind = 'integrator', input = 'y', initial = 0.5 }\nbelow = { kind = 'gain', input = 'x', gain = "
     "-1 }\n",
     "z = { kind = 'lag', input = 'y', time = 0.1 }\n"},
};

constexpr double jumping_span = 2.0;  // [s]

inline std::string ports(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += name + " = { unit = '" +
            (name == "F"                  ? "N"
             : name == "a" || name == "q" ? "m/s^2"
             : name == "x"                ? "m"
                                          : "1") +
            "' }\n";
  return text;
}

/// step 0: it is sampled.
inline std::unique_ptr<Subsystem> part_of_scene(const std::string& blocks,
                                                const std::vector<std::string>& inputs,
                                                const std::vector<std::string>& outputs, double step) {
  return engine::make_subsystem(engine::read_diagram("part", "[inputs]\n" + ports(inputs) + "[blocks]\n" +
                                                                 blocks + "[outputs]\n" + ports(outputs)),
                                {.step = step});
}

/// The largest difference of rows' first output from a signal of one diagram, by fine steps.
inline double difference_from(const std::string& blocks, const std::string& signal,
                              const Recording::Rows& rows) {
  const auto program = engine::compile(
      engine::read_diagram("all", "[blocks]\n" + blocks + "[outputs]\n" + signal + " = { unit = '1' }\n"));
  engine::Simulation whole(program, nullptr, engine::make_integrator({}));
  whole.start(0.0);
  double most = 0.0;
  for (const auto& row : rows) {
    while (whole.time() < row[0]) whole.run(std::min(row[0], whole.time() + 5e-4));
    most = std::max(most, std::abs(row[2] - whole.output(0)));
  }
  return most;
}

/// The largest error of z in all rows of its side, against both as one diagram with a fine step.
struct JumpingRun {
  const JumpingScene& scene;
  std::string schedule = "slowest-first", how = "lagrange3";
  double h = 0.01;  ///< [s]; the one that jumps has 0.7 h
  std::vector<std::string> order = {};
  bool tells = true;
  double error() const;
};

/// As subsystems were before there were events: rows at nodes alone, nothing is held.
class Quiet final : public Subsystem {
 public:
  explicit Quiet(std::unique_ptr<Subsystem> inner) : inner_(std::move(inner)), info_(inner_->info()) {
    info_.abilities = {};
    for (Port& port : info_.outputs) port.held = false;
    data_.resize(static_cast<std::size_t>(2 * info_.row_size()));
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    return inner_->initialize(t_start, t_stop, u0, y);
  }
  /// One own step a call.
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    Samples rows;
    Clock clock{0.0, 0.0, Stop::event};
    while (clock.stop == Stop::event) {
      rows = Samples(data_.data(), info_.row_size(), 2);
      clock = inner_->advance(t_limit, land, u, rows);
    }
    if (rows.size() == 0) return clock;
    const auto last = rows.values(rows.size() - 1);
    std::copy(last.begin(), last.end(), y.append(clock.time));
    return clock;
  }

 private:
  std::unique_ptr<Subsystem> inner_;
  SubsystemInfo info_;
  std::vector<double> data_;
};

inline double JumpingRun::error() const {
  auto first = part_of_scene(scene.jumping, {"z"}, {"y"}, 0.7 * h);
  if (!tells) first = std::make_unique<Quiet>(std::move(first));
  const auto second = part_of_scene(scene.reading, {"y"}, {"z"}, h);
  RunBench bench;
  bench.add("jumping", *first).add("reading", *second).schedule(schedule);
  bench.connect("jumping.y", "reading.y", how).connect("reading.z", "jumping.z", how);
  bench.coordination.order = order;
  return difference_from(scene.jumping + scene.reading, "z", bench.run(jumping_span).all()[1]);
}

}  // namespace tandem::test
