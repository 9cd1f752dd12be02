// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/compiled_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pendulum_block.hpp"
#include "refusal.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::engine {
namespace {

using test::refuses;

Program compiled(const std::string& text, const std::vector<CompiledBlock>& kinds) {
  Description d = read_diagram("d", text);
  d.kinds = kinds;
  return compile(d);
}

/// Beside the same of blocks, rounding apart.
TEST(CompiledBlock, IsABlockLikeOthers) {
  const Program p = compiled(
      "[parameters]\nl = { value = 0.5, unit = 'm' }\n[blocks]\nturn = { kind = 'step', time = 0.2, after = "
      "1 }\n"
      "own = { kind = 'pendulum', torque = 'turn', length = '$l', angle = 0.3 }\n"
      "sine = { kind = 'function', function = 'sin', input = 'a' }\n"
      "rate = { kind = 'sum', inputs = ['turn', 'sine'], gains = [4, -19.62] }\n"
      "w = { kind = 'integrator', input = 'rate' }\na = { kind = 'integrator', input = 'w', initial = 0.3 }\n"
      "[outputs]\nown = { unit = 'rad', from = 'own.angle' }\nspeed = { unit = 'rad/s', from = 'own.speed' "
      "}\n"
      "a = { unit = 'rad' }\nw = { unit = 'rad/s' }\n",
      {pendulum_block()});
  EXPECT_EQ(p.states, 4);
  Simulation s(p, nullptr, make_integrator({}));
  s.start(0.0);
  for (int k = 1; k <= 100; ++k) s.run(0.01 * k);
  EXPECT_NEAR(s.output(0), s.output(2), 1e-13);
  EXPECT_NEAR(s.output(1), s.output(3), 1e-13);
  EXPECT_GT(std::abs(s.output(1)), 0.1);
}

CompiledBlock ratio() {
  return {.kind = "ratio",
          .inputs = {"a", "b"},
          .outputs = {"quotient", "remainder"},
          .output = [](const double*, const double*, const double* u, double* y) {
            y[0] = std::floor(u[0] / u[1]);
            y[1] = u[0] - y[0] * u[1];
          }};
}

TEST(CompiledBlock, HasSeveralOutputsAndFeedthrough) {
  const Program p = compiled(
      "[inputs]\nu = { unit = '1' }\n[blocks]\nr = { kind = 'ratio', a = 'u', b = 3 }\n[outputs]\n"
      "q = { unit = '1', from = 'r.quotient' }\nrest = { unit = '1', from = 'r.remainder' }\n",
      {ratio()});
  EXPECT_EQ(p.feedthrough, (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}}));
  class Eleven : public InputSource {
    void at(double, double* u) override { u[0] = 11.0; }
  } inputs;
  Simulation s(p, &inputs, make_integrator({}));
  s.start(0.0);
  EXPECT_EQ(s.output(0), 3.0);
  EXPECT_EQ(s.output(1), 2.0);
}

/// Its second input comes from blocks after it in the file, which stand behind held values.
TEST(CompiledBlock, ComesAfterAllOfItsInputs) {
  const Program p = compiled(
      "[blocks]\nr = { kind = 'ratio', a = 7, b = 'late' }\n"
      "late = { kind = 'switch', control = 'r.quotient', threshold = 5, above = 2, below = 'twice' }\n"
      "twice = { kind = 'gain', input = 'time', gain = 2 }\n[outputs]\nrest = { unit = '1', from = "
      "'r.remainder' }\n",
      {ratio()});
  Simulation s(p, nullptr, make_integrator({}));
  s.start(2.0);
  EXPECT_EQ(s.output(0), 3.0);
  s.run(3.25);
  EXPECT_EQ(s.output(0), 0.5);
}

/// Its outputs need no inputs, so it may stand in a loop.
TEST(CompiledBlock, WithoutFeedthroughMakesNoLoop) {
  const std::string loop =
      "[blocks]\nown = { kind = 'pendulum', torque = 'back', length = 1, angle = 1 }\n"
      "back = { kind = 'gain', input = 'own.speed', gain = -1 }\n[outputs]\nb = { unit = 'N m', from = "
      "'back' }\n";
  EXPECT_NO_THROW(compiled(loop, {pendulum_block()}));
  CompiledBlock through = pendulum_block();
  through.feedthrough = true;
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"algebraic loop", "own"}, [&] { compiled(loop, {through}); }));
}

TEST(CompiledBlock, IsRefusedByPlace) {
  const auto refused = [](const std::string& keys, const CompiledBlock& kind,
                          const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words, [&] {
      compiled("[blocks]\nb = { " + keys + " }\n[outputs]\nb = { unit = '1', from = 'b.angle' }\n", {kind});
    });
  };
  CompiledBlock empty = pendulum_block();
  empty.rates = nullptr;
  EXPECT_TRUE(refused("kind = 'pendulum', torque = 0, length = 1, angle = 0", empty,
                      {"d:2", "'b'", "without rates"}));
  EXPECT_TRUE(
      refused("kind = 'pendulum', torque = 0, angle = 0", pendulum_block(), {"d:2", "'b'", "no length"}));
  EXPECT_TRUE(
      refused("kind = 'pendulum', torque = 0, length = 1", pendulum_block(), {"d:2", "'b'", "no angle"}));
  EXPECT_TRUE(
      refused("kind = 'pendulum', length = 1, angle = 0", pendulum_block(), {"d:2", "'b'", "no torque"}));
  EXPECT_TRUE(refused("kind = 'pendulm'", pendulum_block(), {"d:2", "'pendulm'", "'pendulum'"}));
}

}  // namespace
}  // namespace tandem::engine
