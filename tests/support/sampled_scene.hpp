// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Systems of linear parts, run, and compared with their exact solution.
#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "adapters.hpp"
#include "exact_samples.hpp"
#include "run_bench.hpp"

namespace tandem::test {

/// How each part is run.
struct Side {
  double step = 0.0;
  Method method = Method::exact;
  std::string how = "lagrange3";  ///< what others read of it
  Landing landing = Landing::automatic;
};

struct SampledScene {
  std::vector<Part> parts;
  std::vector<Wire> wires;
  std::vector<Side> sides;
  double t_start = 0.0, t_stop = 1.0;
};

/// A scene put together, with its parts in the order of `file`.
class SampledRun {
 public:
  SampledRun(const SampledScene& scene, const std::string& schedule, std::vector<int> file = {})
      : scene_(scene), file_(std::move(file)), all_(scene.parts.size()) {
    for (std::size_t i = 0; file_.size() < all_.size(); ++i) file_.push_back(static_cast<int>(i));
    for (const int i : file_) add(static_cast<std::size_t>(i));
    for (const Wire& w : scene.wires) connect(w);
    bench.schedule(schedule);
  }

  /// Rows by part.
  std::vector<Recording::Rows> run() { return by_part(bench.run(scene_.t_stop, scene_.t_start).all()); }
  std::vector<Recording::Rows> by_part(const std::vector<Recording::Rows>& rows) const {
    std::vector<Recording::Rows> all(rows.size());
    for (std::size_t p = 0; p < rows.size(); ++p) all[static_cast<std::size_t>(file_[p])] = rows[p];
    return all;
  }

  RunBench bench;

 private:
  void add(std::size_t i) {
    const Part& part = scene_.parts[i];
    const Side& side = scene_.sides[i];
    if (part.sampled)
      all_[i] = std::make_unique<Sampled<LinearController>>(LinearController(part.system, *part.sampled));
    else
      all_[i] = continuous(part, side);
    bench.add("p" + std::to_string(i), *all_[i]);
    bench.coordination.landing["p" + std::to_string(i)] = side.landing;
  }
  static std::unique_ptr<Subsystem> continuous(const Part& part, const Side& side) {
    auto one = std::make_unique<FixedStep<LinearModel>>(LinearModel(part.system, side.step, side.method));
    return side.method == Method::rk4 ? over_jumps(std::move(one)) : std::move(one);
  }
  void connect(const Wire& w) {
    const auto from = static_cast<std::size_t>(w.from), to = static_cast<std::size_t>(w.to);
    const auto port = [](std::size_t i, const char* ports, int k, Eigen::Index count) {
      return "p" + std::to_string(i) + "." + ports + (count > 1 ? "[" + std::to_string(k) + "]" : "");
    };
    bench.connect(port(from, "y", w.output, scene_.parts[from].system.c.rows()),
                  port(to, "u", w.input, scene_.parts[to].system.b.cols()),
                  scene_.parts[from].sampled ? "" : how(w), w.memory ? Lag::memory : Lag::none);
  }

  /// Staggered is for two that integrate themselves; others read them as they like.
  std::string how(const Wire& w) const {
    const std::string& word = scene_.sides[static_cast<std::size_t>(w.from)].how;
    const bool at_instants = scene_.parts[static_cast<std::size_t>(w.to)].sampled.has_value();
    return at_instants && word == "matched_hold" ? "lagrange2" : word;
  }

  const SampledScene& scene_;
  std::vector<int> file_;
  std::vector<std::unique_ptr<Subsystem>> all_;
};

inline std::vector<Recording::Rows> run(const SampledScene& scene, const std::string& schedule,
                                        std::vector<int> file = {}) {
  return SampledRun(scene, schedule, std::move(file)).run();
}

/// The largest error of all rows, of sampled and continuous parts.
struct Errors {
  double sampled = 0.0, continuous = 0.0;
};

inline Errors errors(const SampledScene& scene, const std::vector<Recording::Rows>& rows) {
  Errors worst;
  ExactSamples exact(scene.parts, scene.wires, scene.t_start);
  std::vector<std::pair<double, std::size_t>> times;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!scene.parts[i].sampled)
      for (const auto& row : rows[i]) times.emplace_back(row[0], i);
  std::sort(times.begin(), times.end());
  std::vector<std::size_t> next(rows.size());
  for (const auto& [t, i] : times) {
    const VectorXd y = exact.before(static_cast<int>(i), t);
    const auto& row = rows[i][next[i]++];
    for (Eigen::Index k = 0; k < y.size(); ++k)
      worst.continuous = std::max(worst.continuous, std::abs(y[k] - row[static_cast<std::size_t>(2 + k)]));
  }
  exact.act_up_to(scene.t_stop);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!scene.parts[i].sampled) continue;
    EXPECT_EQ(rows[i].size(), exact.samples[i].size()) << "part " << i;
    for (std::size_t r = 0; r < std::min(rows[i].size(), exact.samples[i].size()); ++r) {
      const auto& sample = exact.samples[i][r];
      EXPECT_NEAR(rows[i][r][0], sample.t, 1e-12 * std::max(1.0, std::abs(sample.t)));
      for (Eigen::Index k = 0; k < sample.y.size(); ++k)
        worst.sampled =
            std::max(worst.sampled, std::abs(sample.y[k] - rows[i][r][static_cast<std::size_t>(2 + k)]));
    }
  }
  return worst;
}

inline MatrixXd matrix(std::initializer_list<std::initializer_list<double>> rows) {
  MatrixXd m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.begin()->size()));
  Eigen::Index r = 0;
  for (const auto& row : rows) {
    Eigen::Index c = 0;
    for (const double value : row) m(r, c++) = value;
    ++r;
  }
  return m;
}

/// A damped mass on a spring, driven by a force; its position and velocity.
inline Part oscillator(double w, double damping, double x) {
  return {{matrix({{0.0, 1.0}, {-w * w, -2.0 * damping * w}}), matrix({{0.0}, {1.0}}),
           MatrixXd::Identity(2, 2), MatrixXd::Zero(2, 1), VectorXd(Eigen::Vector2d(x, 0.0))}};
}

inline const std::vector<std::string> schedules = {"slowest-first", "fastest-first", "parallel"};

}  // namespace tandem::test
