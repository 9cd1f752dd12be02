// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Jumps that come to a reader through others, whose outputs follow their inputs at once, against all as one diagram.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "jumping_scenes.hpp"

namespace tandem::test::carried_jumps {
namespace {

/// A force F on a plant, its acceleration a through gains with lags, y1 to yN, and a filter q of the last.
struct Chain {
  std::string force;  ///< block F
  bool reads = true;  ///< F reads x
  bool sampled = true;
  int gains = 1;
  std::vector<double> steps = {1.0};  ///< of plant, gains and filter, in units of h
  std::string schedule = "slowest-first";
  std::vector<std::string> order = {};

  std::string last() const { return gains == 0 ? "a" : "y" + std::to_string(gains); }
  std::string gain(int k) const {
    const std::string u = k == 1 ? "a" : "y" + std::to_string(k - 1);
    return fmt::format(
        "w{0} = {{ kind = 'lag', input = '{1}', time = 0.3 }}\n"
        "y{0} = {{ kind = 'sum', inputs = ['{1}', 'w{0}'], gains = [0.8, 0.2] }}\n",
        k, u);
  }
  std::string filter() const {
    return "d = { kind = 'gain', input = '" + last() +
           "', gain = 1 }\nq = { kind = 'lag', input = 'd', time = 0.1 }\n";
  }
  double step(std::size_t k, double h) const { return h * steps[k % steps.size()]; }
  double error(double h) const;
  double mean_error(double h) const;
};

const std::string plant =
    "a = { kind = 'sum', inputs = ['F', 'x', 'v'], gains = [1, -25, -1] }\n"
    "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v' }\n";

double Chain::error(double h) const {
  using Names = std::vector<std::string>;
  RunBench bench;
  std::vector<std::unique_ptr<Subsystem>> parts;
  const auto add = [&](const std::string& name, const std::string& blocks, const Names& in, const Names& out,
                       double own_step) {
    parts.push_back(part_of_scene(blocks, in, out, own_step));
    bench.add(name, *parts.back());
  };
  std::string all = plant + force;
  add("filter", filter(), {last()}, {"q"}, step(0, h));
  add("plant", plant, {"F"}, {"a", "x"}, step(1, h));
  add("force", force, reads ? Names{"x"} : Names{}, {"F"}, sampled ? 0.0 : 0.9 * h);
  if (reads) bench.connect("plant.x", "force.x", "lagrange3");
  bench.connect("force.F", "plant.F", "");
  std::string from = "plant.a";
  for (int k = 1; k <= gains; ++k) {
    const std::string name = "g" + std::to_string(k), u = k == 1 ? "a" : "y" + std::to_string(k - 1);
    add(name, gain(k), {u}, {"y" + std::to_string(k)}, step(static_cast<std::size_t>(k) + 1, h));
    bench.connect(from, name + "." + u, "lagrange3");
    from = name + ".y" + std::to_string(k), all += gain(k);
  }
  bench.connect(from, "filter." + last(), "lagrange3");
  bench.schedule(schedule).coordination.order = order;
  return difference_from(all + filter(), "q", bench.run(jumping_span).all()[0]);
}

/// Of the logarithm, at four steps from h down to near its half: how the grids meet the jumps is another part of a step
/// each time.
double Chain::mean_error(double h) const {
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) sum += std::log2(error(h * std::exp2(-k / 4.0))) / 4.0;
  return sum;
}

const std::string sample =
                      "e = { kind = 'gain', input = 'x', gain = -20, offset = 1 }\n"
                      "F = { kind = 'sample', input = 'e', period = 0.1, offset = 0.013 }\n",
                  of_nothing =
                      "e = { kind = 'sine', amplitude = 2, frequency = 0.7 }\n"
                      "F = { kind = 'sample', input = 'e', period = 0.1, offset = 0.013 }\n",
                  relay = "F = { kind = 'relay', input = 'x', low = -0.02, high = 0.01, on = -1, off = 1 }\n",
                  step = "F = { kind = 'step', time = 0.3137, after = 1 }\n";

/// All end steps at all instants. Behind two gains and more, errors were of order 1.
TEST(CarriedJumps, OfEqualStepsThatMeetTheInstantsAreReadToOrderTwo) {
  const std::string on_grid =
      "e = { kind = 'gain', input = 'x', gain = -4, offset = 1 }\n"
      "F = { kind = 'sample', input = 'e', period = 0.1 }\n";
  for (const int gains : {0, 1, 2, 3})
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
      const Chain chain{.force = on_grid, .gains = gains, .schedule = schedule};
      EXPECT_GT(std::log2(chain.error(0.01) / chain.error(0.00125)) / 3.0, 1.9) << schedule << gains;
    }
}

std::vector<std::string> shuffled(std::vector<std::string> names, std::mt19937& random) {
  std::shuffle(names.begin(), names.end(), random);
  return names;
}

/// Before, errors of readers that lead, and behind two and more, were of order 1.
TEST(CarriedJumps, AreReadToOrderTwoByChance) {
  std::mt19937 random(11);
  const auto number = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const std::tuple<std::string, bool, bool> forces[] = {
      {sample, true, true}, {of_nothing, false, true}, {relay, true, false}, {step, false, false}};
  for (int k = 0; k < 48; ++k) {
    const auto& [force, reads, sampled] = forces[k % 4];
    Chain chain{.force = force, .reads = reads, .sampled = sampled, .gains = k / 4 % 4};
    for (int i = 0; i < chain.gains + 1; ++i) chain.steps.push_back(number(0.6, 1.4));
    chain.schedule = std::vector{"slowest-first", "fastest-first", "parallel"}[random() % 3];
    std::vector<std::string> names{"plant", "filter"};
    if (!sampled) names.push_back("force");
    for (int i = 1; i <= chain.gains; ++i) names.push_back("g" + std::to_string(i));
    if (chain.schedule != "parallel") chain.order = shuffled(names, random);
    const double coarse = chain.mean_error(0.01), fine = chain.mean_error(0.0003125);
    std::string told;
    for (const auto& name : chain.order) told += name + " ";
    EXPECT_GT((coarse - fine) / 5.0, 1.6) << k << ' ' << chain.schedule << ' ' << told << std::exp2(fine);
    EXPECT_LT(std::exp2(fine), 3e-3) << k << ' ' << chain.schedule << ' ' << told;
  }
}

}  // namespace
}  // namespace tandem::test::carried_jumps
