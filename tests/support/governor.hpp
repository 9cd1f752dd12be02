// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <utility>

#include "run_bench.hpp"
#include "tandem/sampled.hpp"

namespace tandem::test {

/// An integral and a proportional part, every 0.3 s from 0.05 s on.
class Governor {
 public:
  explicit Governor(double latency, std::string unit = "m") : latency_(latency), unit_(std::move(unit)) {}
  SubsystemInfo info() const {
    return {"controller",
            {{"u", unit_, 1, 0, 0.0}},
            {{"y", unit_ == "m" ? "N" : "1"}},
            {{0, 0}},
            {.serializes_state = true}};
  }
  double own_step() const { return 0.3; }
  double offset() const { return 0.05; }
  double latency() const { return latency_; }
  void start(double, std::span<const double>) { sum_ = 0.25; }
  void outputs(double* y) const { *y = -sum_; }
  void outputs(double* y, std::span<const double> u) const { *y = -sum_ - 0.5 * u[0]; }
  void step(const OwnStep& s, std::span<const Signal> u) { sum_ += 0.2 * u[0].value(s.begin); }
  void write(ByteWriter& to) const { to.put(sum_); }
  void read(ByteReader& from) { sum_ = from.take<double>(); }

 private:
  double latency_, sum_ = 0.0;
  std::string unit_;
};

/// It is late by 0.02 s.
inline std::unique_ptr<Subsystem> governor(const std::string& = "") {
  return std::make_unique<Sampled<Governor>>(Governor(0.02));
}

/// The position of an oscillator to the controller, its force back.
inline std::vector<Recording::Rows> controlled(Subsystem& plant, Subsystem& sampled) {
  RunBench bench;
  bench.add("plant", plant).add("control", sampled);
  bench.connect("plant.x", "control.u", "lagrange3").connect("control.y", "plant.F", "");
  return bench.run(5.0).all();
}

}  // namespace tandem::test
