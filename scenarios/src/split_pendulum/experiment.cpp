// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/experiment.hpp"

#include <algorithm>
#include <cmath>

#include "split_pendulum/coupling.hpp"

namespace tandem::split_pendulum {
namespace {

constexpr double lost = 0.5;  // [m]

/// Gathers the distances of the first side's x and y.
class Distance final : public Observer {
 public:
  explicit Distance(const Truth& truth) : truth_(truth) {}
  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t k = first; k <= last && subsystem == 0 && largest_ <= lost; ++k) {
      const auto values = history.values(k);
      const double d = (Eigen::Vector2d(values[0], values[1]) - truth_.elbow(history.time(k))).norm();
      largest_ = std::max(largest_, d);
      sum_ += d * d;
      ++count_;
      time_ = history.time(k);
    }
    return largest_ <= lost;
  }
  Outcome outcome(const std::string& note) const {
    Outcome o{largest_, std::sqrt(sum_ / static_cast<double>(count_)), note.empty(), note};
    if (o.largest > lost) o.stable = false, o.note = "lost at " + std::to_string(time_) + " s";
    return o;
  }

 private:
  const Truth& truth_;
  double largest_ = 0.0, sum_ = 0.0, time_ = 0.0;
  std::int64_t count_ = 0;
};

Coupling coupling(const Case& c) {
  const Scheme& s = c.scheme;
  if (s.monolithic())
    return {{{"both", monolithic_text(c.rods), c.step}}, {}, s.formulation, "slowest-first", t_stop};
  const double small = c.step / s.ratio;
  const bool lower_fast = s.fast == "lower";
  Coupling coupling{{{"upper", upper_text(c.rods), lower_fast ? c.step : small},
                     {"lower", lower_text(c.rods), lower_fast ? small : c.step}},
                    {},
                    s.formulation,
                    s.schedule,
                    t_stop};
  const auto down = Reconstruction::parse(s.to_lower), up = Reconstruction::parse(s.to_upper);
  for (const std::string axis : {"x", "y"}) {
    coupling.connections.push_back({"upper." + axis, "lower." + axis, down});
    coupling.connections.push_back(
        {.from = "lower.R" + axis, .to = "upper.F" + axis, .how = up, .gain = -1.0, .lag = s.lag});
    if (c.rods.carried_mass != 0.0)
      coupling.connections.push_back(
          {.from = "lower.a" + axis, .to = "upper.a" + axis, .how = up, .lag = s.lag});
  }
  return coupling;
}

}  // namespace

Outcome run_case(const Case& c, const Truth& truth) {
  Distance distance(truth);
  const std::string note = run(coupling(c), distance);
  return distance.outcome(note);
}

}  // namespace tandem::split_pendulum
