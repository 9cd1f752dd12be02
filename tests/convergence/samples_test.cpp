// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sampled subsystems beside continuous ones, against the exact solution.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "cut_run.hpp"
#include "exact_samples.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"

namespace tandem::test {
namespace {

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
      all_[i] = std::make_unique<FixedStep<LinearModel>>(LinearModel(part.system, side.step, side.method));
    bench.add("p" + std::to_string(i), *all_[i]);
    bench.coordination.landing["p" + std::to_string(i)] = side.landing;
  }
  void connect(const Wire& w) {
    const auto from = static_cast<std::size_t>(w.from), to = static_cast<std::size_t>(w.to);
    const auto port = [](std::size_t i, const char* ports, int k, Eigen::Index count) {
      return "p" + std::to_string(i) + "." + ports + (count > 1 ? "[" + std::to_string(k) + "]" : "");
    };
    bench.connect(port(from, "y", w.output, scene_.parts[from].system.c.rows()),
                  port(to, "u", w.input, scene_.parts[to].system.b.cols()),
                  scene_.parts[from].sampled ? "" : scene_.sides[from].how,
                  w.memory ? Lag::memory : Lag::none);
  }

  const SampledScene& scene_;
  std::vector<int> file_;
  std::vector<std::unique_ptr<Subsystem>> all_;
};

std::vector<Recording::Rows> run(const SampledScene& scene, const std::string& schedule,
                                 std::vector<int> file = {}) {
  return SampledRun(scene, schedule, std::move(file)).run();
}

/// The largest error of all rows, of sampled and continuous parts.
struct Errors {
  double sampled = 0.0, continuous = 0.0;
};

Errors errors(const SampledScene& scene, const std::vector<Recording::Rows>& rows) {
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

MatrixXd matrix(std::initializer_list<std::initializer_list<double>> rows) {
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
Part oscillator(double w, double damping, double x) {
  return {{matrix({{0.0, 1.0}, {-w * w, -2.0 * damping * w}}), matrix({{0.0}, {1.0}}),
           MatrixXd::Identity(2, 2), MatrixXd::Zero(2, 1), VectorXd(Eigen::Vector2d(x, 0.0))}};
}

/// A controller with an integral and a proportional part.
Part controller(double gain, double integral, LinearController::Times times) {
  return {{matrix({{1.0}}), matrix({{integral * times.period}}), matrix({{-1.0}}), matrix({{-gain}}),
           VectorXd::Zero(1)},
          times};
}

/// One plant and one controller that reads its position.
SampledScene one_loop(double step, Method method, LinearController::Times times) {
  return {{oscillator(5.0, 0.05, 1.0), controller(4.0, 6.0, times)},
          {{0, 0, 1, 0}, {1, 0, 0, 0}},
          {{step, method}, {}}};
}

const std::vector<std::string> schedules = {"slowest-first", "fastest-first", "parallel"};

TEST(Samples, OneExactPlantThatLandsIsRightToRounding) {
  for (const auto& times :
       std::vector<LinearController::Times>{{0.1}, {0.1, 0.03}, {0.07, 0.011, 0.02}, {0.05, 0.0, 0.13}})
    for (const double step : {0.01, 0.013, 0.05}) {
      const SampledScene scene = one_loop(step, Method::exact, times);
      const auto first = run(scene, "slowest-first");
      for (const std::string& schedule : schedules) {
        const auto rows = run(scene, schedule);
        const Errors e = errors(scene, rows);
        EXPECT_LT(e.sampled, 1e-12) << schedule << " " << step << " " << times.period << " " << times.latency;
        EXPECT_LT(e.continuous, 1e-12)
            << schedule << " " << step << " " << times.period << " " << times.latency;
        EXPECT_TRUE(same_bits(rows, first)) << schedule;
        EXPECT_TRUE(same_bits(run(scene, schedule, {1, 0}), first)) << schedule;
      }
    }
}

double order_of(const std::vector<double>& errors) {
  return std::log2(errors[errors.size() - 2] / errors.back());
}

TEST(Samples, OneRungeKuttaPlantThatLandsIsOfOrderFour) {
  for (const Method method : {Method::rk4, Method::rk4_split})
    for (const LinearController::Times times : {LinearController::Times{0.1, 0.037}, {0.11, 0.0, 0.029}}) {
      std::vector<double> all;
      for (const double step : {0.04, 0.02, 0.01}) {
        const SampledScene scene = one_loop(step, method, times);
        const auto rows = run(scene, "slowest-first");
        for (const std::string& schedule : schedules)
          EXPECT_TRUE(same_bits(run(scene, schedule), rows)) << schedule;
        const Errors e = errors(scene, rows);
        all.push_back(std::max(e.sampled, e.continuous));
      }
      EXPECT_NEAR(order_of(all), 4.0, 0.25) << all[0] << " " << all[1] << " " << all[2];
    }
}

/// A plant of two masses in two continuous parts, joined by a spring, and a controller of the second that
/// moves the first.
SampledScene two_plants(double step, LinearController::Times times, const std::string& how,
                        Landing landing = Landing::automatic, Method method = Method::exact) {
  Part first = oscillator(6.0, 0.05, 0.5), second = oscillator(4.0, 0.03, 1.0);
  first.system.b = matrix({{0.0, 0.0}, {3.0, 1.0}});  // the other's position, and the controller's force
  second.system.b = matrix({{0.0}, {2.0}});
  for (Part* part : {&first, &second}) part->system.d = MatrixXd::Zero(2, part->system.b.cols());
  const Side a{step, method, how, landing}, b{0.7 * step, method, how, landing};
  return {{first, second, controller(1.5, 2.0, times)},
          {{1, 0, 0, 0}, {0, 0, 1, 0}, {1, 0, 2, 0}, {2, 0, 0, 1}},
          {a, b, {}},
          0.0,
          2.0};
}

double last_order(const std::string& schedule, const std::string& how, Landing landing, Method method) {
  std::vector<double> all;
  for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
    const SampledScene scene = two_plants(step, {0.1, 0.013}, how, landing, method);
    const Errors e = errors(scene, run(scene, schedule));
    all.push_back(std::max(e.sampled, e.continuous));
  }
  return order_of(all);
}

/// Velocities kink at each instant: order 3 at most.
TEST(Samples, TwoPlantsThatLandKeepTheOrderOfTheirReconstructionUpToThree) {
  for (const std::string& schedule : schedules) {
    EXPECT_NEAR(last_order(schedule, "lagrange1", Landing::automatic, Method::exact), 2.0, 0.2) << schedule;
    EXPECT_NEAR(last_order(schedule, "lagrange3", Landing::automatic, Method::exact), 3.0, 0.2) << schedule;
  }
}

TEST(Samples, WithoutLandingTheOrderIsKeptByWhoSplitsAndNotByWhoGoesOverBreaks) {
  const auto worst = [](const SampledScene& scene, const std::string& schedule) {
    const Errors e = errors(scene, run(scene, schedule));
    return std::max(e.sampled, e.continuous);
  };
  for (const std::string& schedule : schedules) {
    EXPECT_NEAR(last_order(schedule, "lagrange3", Landing::never, Method::exact), 3.0, 0.2) << schedule;
    const auto over = two_plants(0.005, {0.1, 0.013}, "lagrange3", Landing::never, Method::rk4),
               split = two_plants(0.005, {0.1, 0.013}, "lagrange3", Landing::never, Method::rk4_split);
    EXPECT_GT(worst(over, schedule), 100.0 * worst(split, schedule)) << schedule;
  }
}

class RandomScenes {
 public:
  SampledScene next() {
    SampledScene scene;
    const int plants = 1 + number(4), controllers = 1 + number(3), all = plants + controllers;
    const double period = 0.05 + 0.1 * part();
    for (int i = 0; i < all; ++i) scene.parts.push_back(i < plants ? plant() : sampled(period));
    for (int i = 0; i < all; ++i) scene.sides.push_back(side(i < plants));
    for (int to = 0; to < all; ++to)
      for (int input = 0; input < 2; ++input) wire(scene, to, input, plants);
    scene.t_start = number(3) == 0 ? 10.0 * part() - 5.0 : 0.0;
    scene.t_stop = scene.t_start + 1.0 + part();
    return scene;
  }
  std::vector<int> order(std::size_t size) {
    std::vector<int> all(size);
    std::iota(all.begin(), all.end(), 0);
    std::shuffle(all.begin(), all.end(), random_);
    return all;
  }

 private:
  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  double part() { return std::uniform_real_distribution<>(0.0, 1.0)(random_); }

  Part plant() {
    Part p = oscillator(2.0 + 4.0 * part(), 0.1 * part(), part());
    p.system.b = matrix({{0.0, 0.0}, {part(), part()}});
    p.system.d = MatrixXd::Zero(2, 2);
    return p;
  }
  /// Two outputs, of which the second follows its inputs at once.
  Part sampled(double period) {
    const std::vector<double> periods = {period, period, 2.0 * period, 0.7 * period};
    const LinearController::Times times{periods[static_cast<std::size_t>(number(4))],
                                        number(2) == 0 ? 0.0 : 0.1 * part(),
                                        number(3) == 0 ? 0.15 * part() : 0.0};
    return {{matrix({{0.6}}), matrix({{0.2, 0.1}}), matrix({{1.0}, {0.5}}), matrix({{0.0, 0.0}, {-0.4, 0.3}}),
             VectorXd::Constant(1, part())},
            times};
  }
  Side side(bool continuous) {
    if (!continuous) return {};
    const Landing landing =
        std::vector{Landing::automatic, Landing::never, Landing::always}[static_cast<std::size_t>(number(3))];
    return {0.002 + 0.004 * part(), Method::exact, "lagrange3", landing};
  }
  /// Between controllers from the first output to any, from the second to later ones alone, or with a memory.
  void wire(SampledScene& scene, int to, int input, int plants) {
    const int from = number(static_cast<int>(scene.parts.size())), output = number(2);
    if (from == to || number(4) == 0) return;
    const bool among = from >= plants && to >= plants;
    scene.wires.push_back({from, output, to, input, among && (number(3) == 0 || (output == 1 && from > to))});
  }

  std::mt19937_64 random_{20261123};
};

TEST(Samples, AnySystemInAnyOrderOfTheFile) {
  RandomScenes scenes;
  for (int k = 0; k < 60; ++k) {
    const SampledScene scene = scenes.next();
    for (const std::string& schedule : schedules) {
      const auto rows = run(scene, schedule);
      EXPECT_TRUE(same_bits(run(scene, schedule, scenes.order(scene.parts.size())), rows))
          << k << " " << schedule;
      const Errors e = errors(scene, rows);
      EXPECT_LT(std::max(e.sampled, e.continuous), 1e-3) << k << " " << schedule;
      SampledRun before(scene, schedule), after(scene, schedule);
      EXPECT_TRUE(same_bits(cut_after(3 + k, before.bench, after.bench, {scene.t_start, scene.t_stop}), rows))
          << k << " " << schedule;
    }
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace tandem::test
