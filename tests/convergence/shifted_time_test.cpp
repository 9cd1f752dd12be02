// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A run that starts at another time is the same run, but for the rounding of times.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "sampled_scene.hpp"

namespace tandem::test {
namespace {

/// Two masses on springs that push each other by their positions, and a controller of the second that pushes
/// the first, every `period` [s]; 0: there is none.
SampledScene pair_of_masses(double ratio, double period, const std::string& how) {
  SampledScene scene{{oscillator(6.0, 0.05, 0.5), oscillator(4.0, 0.03, 1.0)},
                     {{1, 0, 0, 0}, {0, 0, 1, 0}},
                     {{0.013 / ratio, Method::rk4_split, how}, {0.013, Method::rk4_split, how}},
                     0.0,
                     4.0};
  for (Part& part : scene.parts) part.system.b = matrix({{0.0, 0.0}, {2.0, 1.0}});
  for (Part& part : scene.parts) part.system.d = MatrixXd::Zero(2, 2);
  if (period == 0.0) return scene;
  const auto one = [](double value) { return MatrixXd::Constant(1, 1, value); };
  scene.parts.push_back(
      {{one(0.9), one(0.1), one(-0.5), one(-0.5), VectorXd::Zero(1)}, {{period, 0.3 * period}}});
  scene.sides.push_back({});
  scene.wires.push_back({1, 0, 2, 0});
  scene.wires.push_back({2, 0, 0, 1});
  return scene;
}

/// Subsystems with steps, periods and offsets that meet often, and some that never do.
class MeetingScenes {
 public:
  SampledScene next() {
    const int plants = 1 + number(3), controllers = number(3), all = plants + controllers;
    SampledScene scene{{}, {}, {}, 0.0, 1.0 + 0.1 * number(4)};
    for (int i = 0; i < all; ++i) scene.parts.push_back(i < plants ? plant() : controller());
    for (int i = 0; i < all; ++i) scene.sides.push_back(i < plants ? side() : Side{});
    for (int to = 0; to < all; ++to)
      for (int input = 0; input < 2; ++input) wire(scene, to, input, plants);
    return scene;
  }
  /// Two plants that hold each other, for staggered.
  SampledScene pair() {
    SampledScene scene{{plant(), plant()}, {{0, 0, 1, 0}, {1, 0, 0, 0}}, {side(), side()}, 0.0, 1.0};
    for (Side& s : scene.sides) s.how = "matched_hold", s.method = Method::rk4_split;
    return scene;
  }

 private:
  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  double part() { return std::uniform_real_distribution<>(0.0, 1.0)(random_); }
  template <class T>
  T one_of(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(number(static_cast<int>(list.size())))];
  }

  Part plant() {
    Part p = oscillator(2.0 + 4.0 * part(), 0.1 * part(), part());
    p.system.b = matrix({{0.0, 0.0}, {part(), part()}});
    p.system.d = MatrixXd::Zero(2, 2);
    return p;
  }
  Part controller() {
    const double period = one_of<double>({0.01, 0.02, 0.05, 0.1, 0.037});
    const LinearController::Times times{period, one_of<double>({0.0, 0.5 * period, 0.005, 0.1 * part()}),
                                        one_of<double>({0.0, 0.0, 0.5 * period, period})};
    return {{matrix({{0.6}}), matrix({{0.2, 0.1}}), matrix({{1.0}, {0.5}}), matrix({{0.0, 0.0}, {-0.4, 0.3}}),
             VectorXd::Constant(1, part())},
            times};
  }
  Side side() {
    return {one_of<double>({0.01, 0.01, 0.02, 0.005, 0.05, 0.013, 0.01 / 3.0, 0.3 / 17.0}),
            one_of<Method>({Method::exact, Method::rk4_split, Method::rk4}),
            one_of<std::string>({"lagrange0", "lagrange1", "lagrange2", "lagrange3", "lagrange4",
                                 "least_squares1_2", "least_squares2_8"}),
            one_of<Landing>({Landing::automatic, Landing::never, Landing::always})};
  }
  /// From a plant with a memory now and then; among controllers from the first output, or from the second to
  /// later ones.
  void wire(SampledScene& scene, int to, int input, int plants) {
    const int from = number(static_cast<int>(scene.parts.size())), output = number(2);
    if (from == to || number(5) == 0) return;
    const bool among = from >= plants && to >= plants;
    scene.wires.push_back(
        {from, output, to, input, (!among && number(3) == 0) || (among && output == 1 && from > to)});
  }

  std::mt19937_64 random_{20261125};
};

/// The largest difference of two runs of which one is later; infinite if one has other rows.
double difference(const std::vector<Recording::Rows>& a, const std::vector<Recording::Rows>& b) {
  double largest = 0.0;
  for (std::size_t who = 0; who < a.size(); ++who) {
    if (a[who].size() != b[who].size()) return std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < a[who].size(); ++row)
      for (std::size_t k = 2; k < a[who][row].size(); ++k)
        largest = std::max(largest, std::abs(a[who][row][k] - b[who][row][k]));
  }
  return largest;
}

/// The same, from and to `shift` later.
double shifted(SampledScene scene, const std::string& schedule, double shift) {
  const auto expected = run(scene, schedule);
  scene.t_start += shift, scene.t_stop += shift;
  return difference(run(scene, schedule), expected);
}

class ShiftedTime : public testing::TestWithParam<double> {
 protected:
  /// Times are rounded by up to eps |t|, which shifts what lies between two nodes by as much. Values change
  /// by up to some 10 a second, so by 10 eps |t| in each of up to some 1000 steps at worst. A round more or
  /// less would be seen: it changes values by 1e-6 and more.
  static double rounding() {
    return 1e-12 + 1e4 * std::numeric_limits<double>::epsilon() * std::abs(GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(Starts, ShiftedTime, testing::Values(0.1, -1.3, 100.1, 1e5));

TEST_P(ShiftedTime, ChangesNothingBeyondRounding) {
  for (const std::string& schedule : schedules)
    for (const std::string how : {"lagrange0", "lagrange1", "lagrange3", "least_squares1_2"})
      for (const double ratio : {1.0, 7.0, 31.4159})
        for (const double period : {0.0, 0.05})
          EXPECT_LT(shifted(pair_of_masses(ratio, period, how), schedule, GetParam()), rounding())
              << schedule << " " << how << " " << ratio << " " << period;
}

TEST_P(ShiftedTime, ChangesNothingInRandomSystems) {
  MeetingScenes scenes;
  for (int k = 0; k < 200; ++k) {
    const SampledScene scene = scenes.next(), pair = scenes.pair();
    for (const std::string& schedule : schedules)
      EXPECT_LT(shifted(scene, schedule, GetParam()), rounding()) << k << " " << schedule;
    for (const char* schedule : {"slowest-first", "fastest-first", "staggered"})
      EXPECT_LT(shifted(pair, schedule, GetParam()), rounding()) << k << " " << schedule;
  }
}

}  // namespace
}  // namespace tandem::test
