// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams whose inputs react (tandem/reaction.h), beside diagrams that have the reaction inside.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "refusal.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"

namespace tandem::engine {
namespace {

std::unique_ptr<Subsystem> diagram(const std::string& text, const std::string& integrator = "rk4") {
  return make_subsystem(read_diagram("d", text), {.step = 0.01, .integrator = {.name = integrator}});
}

/// A mass on a spring that is put back where it comes to 1, F on another spring.
std::string mass(const std::string& inputs, const std::string& u, const std::string& more) {
  return inputs + "[blocks]\n" + more + "F = { kind = 'sum', inputs = ['x', '" + u +
         "'], gains = [5, -5] }\na = { kind = 'sum', inputs = ['x', 'F'], gains = [-9, -1] }\n"
         "v = { kind = 'integrator', input = 'a', initial = 3, reset = 'hit', reset_to = -2 }\n"
         "x = { kind = 'integrator', input = 'v' }\nhit = { kind = 'sum', inputs = ['x', 1], gains = [1, "
         "-0.5] }\n"
         "[outputs]\nx = { unit = '1' }\nF = { unit = '1' }\nv = { unit = '1' }\n" +
         (more.empty() ? "" : "z = { unit = '1' }\n");
}
const std::string inside =
    "w = { kind = 'sum', inputs = ['F', 'z'], gains = [0.7, -2] }\nw2 = { kind = 'integrator', input = 'w' "
    "}\n"
    "z = { kind = 'integrator', input = 'w2' }\nu = { kind = 'gain', input = 'z', gain = 0.5 }\n";

/// z'' = 0.7 F - 2 z, and u = 0.5 z.
struct Oscillating {
  static constexpr std::int32_t z = 0, rate = 1, force = 2 + 1;
  std::vector<tandem_reaction_term> terms{{z, rate, 1.0, 0.0}, {rate, z, -2.0, 0.0}, {rate, force, 0.7, 0.0}};
  std::vector<double> begin{0.0, 0.0};
  Reaction reaction{2, 3, 0, 0.0, terms.data(), nullptr, begin.data()};
  tandem_reactive_input input{&reaction, z, 0.5};
};

/// Rows up to t, call by call. `u`: null for a diagram without inputs.
std::vector<std::vector<double>> rows_of(Subsystem& s, Oscillating* u, double t, std::int64_t room) {
  const std::int64_t stride = s.info().row_size() + (u ? 2 : 0);
  const Segment none = {1e9, 0.0, {0.0}};
  const Signal signal = Signal(&none, 1, 0).with(u ? &u->input : nullptr);
  const double u0 = 0.0;
  std::vector<double> memory(static_cast<std::size_t>(stride * room));
  Samples first(memory.data(), stride, room);
  Clock clock = s.initialize(0.0, t, {&u0, u ? 1U : 0U}, first);
  std::vector<std::vector<double>> all;
  while (clock.next_time < t) {
    Samples y(memory.data(), stride, room);
    clock = s.advance(t, false, {&signal, u ? 1U : 0U}, y);
    for (std::int64_t row = 0; row < y.size(); ++row)
      all.emplace_back(memory.begin() + row * stride, memory.begin() + (row + 1) * stride);
    if (u) std::copy(all.back().end() - 2, all.back().end(), u->begin.begin());
  }
  return all;
}

const std::string one_input = "[inputs]\nu = { unit = '1' }\n";

/// Events on the way included, which change no state of the reaction.
TEST(DiagramWithReaction, IsAsOneThatHasItInside) {
  Oscillating u;
  const auto apart = diagram(mass(one_input, "u", "")), whole = diagram(mass("", "u", inside));
  ASSERT_TRUE(apart->info().abilities.reactive_inputs);
  const auto found = rows_of(*apart, &u, 4.005, 1000), expected = rows_of(*whole, nullptr, 4.005, 1000);
  ASSERT_EQ(found.size(), expected.size());
  int events = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const std::size_t column : {0U, 1U, 2U, 3U, 4U})
      EXPECT_NEAR(found[k][column], expected[k][column], 1e-10);
    EXPECT_NEAR(found[k][found[k].size() - 2], expected[k][5], 1e-10);
    events += found[k][1] == 1.0 ? 1 : 0;
  }
  EXPECT_GT(events, 1);
}

TEST(DiagramWithReaction, HasTheSameBitsInCallsOfAnyLength) {
  const auto rows = [](std::int64_t room) {
    Oscillating u;
    return rows_of(*diagram(mass(one_input, "u", "")), &u, 4.005, room);
  };
  EXPECT_EQ(rows(2), rows(1000));
}

TEST(DiagramWithReaction, RefusesMoreStatesThanItHasRoomFor) {
  Oscillating u;
  u.begin.resize(7), u.reaction.states = 7, u.reaction.begin = u.begin.data();
  const auto d = diagram(mass(one_input, "u", ""));
  EXPECT_TRUE(
      test::refuses(ErrorCode::not_supported, {"7 states", "up to 6"}, [&] { rows_of(*d, &u, 1.0, 1000); }));
}

/// Integrators with a past of their own, and a diagram with no input, do not say that they can.
TEST(DiagramWithReaction, IsOneOfTheClassicalMethodWithInputs) {
  EXPECT_FALSE(diagram(mass("", "u", inside))->info().abilities.reactive_inputs);
#if TANDEM_SUNDIALS
  EXPECT_FALSE(diagram(mass(one_input, "u", ""), "cvode_bdf")->info().abilities.reactive_inputs);
#endif
}

}  // namespace
}  // namespace tandem::engine
