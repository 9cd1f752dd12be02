// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any number of sampled and continuous subsystems, in any order of the file, cut and resumed anywhere.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "cut_run.hpp"
#include "same_bits.hpp"
#include "sampled_scene.hpp"

namespace tandem::test {
namespace {

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
    return {number(2) == 0 ? 0.004 : 0.002 + 0.004 * part(), Method::exact, "lagrange3", landing};
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

TEST(RandomSamples, AnySystemInAnyOrderOfTheFile) {
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
