// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Tables of one and two variables, and columns of files.
#include <gtest/gtest.h>

#include "diagram_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/engine/surface.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;
using test::refuses;
using Between = Curve::Between;
using Beyond = Curve::Beyond;

/// 1 + 2 x + 3 y + x y, which straight lines along both axes have exactly.
TEST(Tables, OfTwoVariablesAreBilinear) {
  const Surface s("s", {{0, 1, 3}, {-1, 2}, {-2, 7, -1, 11, 1, 19}}, Between::linear, Beyond::extend);
  const auto z = [](double x, double y) { return 1.0 + 2.0 * x + 3.0 * y + x * y; };
  for (const double x : {0.0, 0.3, 1.0, 2.2, 3.0, 4.0, -1.0})
    for (const double y : {-1.0, 0.4, 2.0, 3.0, -2.0}) EXPECT_NEAR(s(x, y), z(x, y), 1e-14) << x << " " << y;
}

TEST(Tables, OfTwoVariablesHoldTheirEdges) {
  const Surface s("s", {{0, 1}, {0, 1}, {1, 2, 3, 5}}, Between::linear, Beyond::hold);
  EXPECT_EQ(s(-1.0, 0.5), 1.5);
  EXPECT_EQ(s(2.0, 7.0), 5.0);
  EXPECT_EQ(s(0.5, -3.0), 2.0);
}

/// Along a line of the grid it is the cubic of one variable, and it stays between the points.
TEST(Tables, OfTwoVariablesAreMonotoneCubicsAlongTheLinesOfTheirGrid) {
  const std::vector<double> x = {0, 1, 2.5, 3}, y = {0, 0.5, 2, 2.5},
                            z = {0, 0, 1, 4, 1, 2, 2, 5, 1, 3, 8, 9, 2, 3, 9, 10};
  const Surface s("s", {x, y, z}, Between::cubic, Beyond::hold);
  const Curve row("r", y, {1, 2, 2, 5}, Between::cubic, Beyond::hold),
      column("c", x, {0, 2, 3, 3}, Between::cubic, Beyond::hold);
  for (double t = -0.5; t < 3.5; t += 0.11) {
    EXPECT_NEAR(s(1.0, t), row(t), 1e-14);
    EXPECT_NEAR(s(t, 0.5), column(t), 1e-14);
    EXPECT_GE(s(t, 1.0), 0.0);
    EXPECT_LE(s(t, 1.0), 8.0);
  }
}

TEST(Tables, RefuseWhatIsNoGrid) {
  const auto code = ErrorCode::invalid_argument;
  const auto of = [](const Surface::Grid& grid) {
    return [grid] { Surface("block 's'", grid, Between::linear, Beyond::hold); };
  };
  EXPECT_TRUE(refuses(code, {"'s'", "5 values", "2 rows of 2"}, of({{0, 1}, {0, 1}, {1, 2, 3, 5, 6}})));
  EXPECT_TRUE(refuses(code, {"'s'", "the point 0 after 1"}, of({{1, 0}, {0, 1}, {1, 2, 3, 5}})));
  EXPECT_TRUE(refuses(code, {"'s'", "the point 0 after 0"}, of({{0, 1}, {0, 0}, {1, 2, 3, 5}})));
  EXPECT_TRUE(refuses(code, {"d:2", "'y' of kind table2", "an array of 1", "one of 2"}, [] {
    compile(
        read_diagram("d",
                     "[blocks]\ny = { kind = 'table2', inputs = ['time'], x = [0, 1], y = [0, 1], z = [0, "
                     "0, 0, 0] }\n[outputs]\ny = { unit = '1' }\n"));
  }));
}

TEST(Tables, RefuseWhatIsBeyondThemWhereTheyAreToldTo) {
  DiagramRun run(
      "[blocks]\ny = { kind = 'table', input = 'time', x = [0, 0.5], y = [0, 1], beyond = 'refuse' }\n"
      "z = { kind = 'table2', inputs = ['y', 'time'], x = [0, 1], y = [0, 1], z = [0, 1, 2, 3] }\n"
      "[outputs]\nz = { unit = '1' }\n");
  run.run(0.5, 5);
  EXPECT_EQ(run.simulation.output(0), 2.0 + 0.5);
  EXPECT_TRUE(refuses(ErrorCode::numerical,
                      {"block 'y' of kind table", "its input is 0.6 at t = 0.6 s", "0 to 0.5"},
                      [&] { run.simulation.step(0.6); }));
}

class Files : public testing::Test {
 protected:
  /// The value at t of y, a block of kind csv with these keys.
  double at(double t, const std::string& keys) const {
    folder.write("d.toml", "[blocks]\ny = { kind = 'csv', file = 'u.csv', " + keys +
                               " }\n[outputs]\ny = { unit = '1' }\n");
    const Program program = compile(read_diagram(folder.path() / "d.toml"));
    Simulation s(program, nullptr, make_integrator({}));
    s.start(0.0);
    s.step(t);
    return s.output(0);
  }
  const test::Scratch folder;
};

TEST_F(Files, AreColumnsOverTimeFromTheDiagramsFolder) {
  folder.write("u.csv", "time,u,w\n0,1,5\n0.5,3,4\n2,0,4.5\n");
  EXPECT_EQ(at(0.25, "column = 'u'"), 2.0);
  EXPECT_NEAR(at(1.0, "column = 'w'"), 4.0 + 0.5 / 3.0, 1e-15);
  EXPECT_EQ(at(2.0, "column = 'u'"), 0.0);
  EXPECT_EQ(at(3.0, "column = 'w', beyond = 'hold'"), 4.5);
}

/// Own steps of 0.3 s end at the jumps, so that each part is integrated for itself.
TEST_F(Files, JumpWhereATimeIsThereTwice) {
  folder.write("u.csv", "time,u\n0,1\n0.5,3\n0.5,7\n2,7\n2,0\n3,0\n");
  folder.write("d.toml",
               "[blocks]\ny = { kind = 'csv', file = 'u.csv', column = 'u' }\n"
               "x = { kind = 'integrator', input = 'y' }\n"
               "[outputs]\ny = { unit = '1' }\nx = { unit = 's' }\n");
  const Program program = compile(read_diagram(folder.path() / "d.toml"));
  for (const char* integrator : {"rk4", "cvode_bdf"}) {
    Simulation s(program, nullptr, make_integrator({integrator}));
    s.start(0.0);
    for (int k = 1; k <= 10; ++k) s.run(0.3 * k);
    EXPECT_NEAR(s.output(1), 1.0 + 1.5 * 7.0, 1e-7) << integrator;
    if (integrator == std::string("rk4")) {
      EXPECT_NEAR(s.output(1), 11.5, 1e-14);
    }
    EXPECT_EQ(s.output(0), 0.0);
  }
  Simulation late(program, nullptr, make_integrator({}));
  late.start(0.5);
  EXPECT_EQ(late.output(0), 7.0) << "what holds from a jump at the start on";
  EXPECT_TRUE(late.run_to_jump(2.5));
  EXPECT_EQ(late.time(), 2.0);
  EXPECT_EQ(late.left()[0], 7.0);
  EXPECT_EQ(late.output(0), 0.0);
}

TEST_F(Files, AreHeldOrSmoothWhereTheySaySo) {
  folder.write("u.csv", "time,u\n0,1\n1,3\n2,1\n");
  EXPECT_EQ(at(0.9, "column = 'u', interpolation = 'hold'"), 1.0);
  EXPECT_EQ(at(1.0, "column = 'u', interpolation = 'hold'"), 3.0);
  EXPECT_EQ(at(0.5, "column = 'u', interpolation = 'spline'"), 2.375);
}

/// At the instant of a jump what holds from then on, also in a diagram that is not sampled wholly.
TEST_F(Files, AreSampledAsTheyAreAfterAJump) {
  folder.write("u.csv", "time,u\n0,1\n0.2,1\n0.2,5\n0.35,5\n0.35,9\n1,9\n");
  const std::string blocks =
                        "[blocks]\nu = { kind = 'csv', file = 'u.csv', column = 'u' }\n"
                        "r = { kind = 'switch', control = 'u', threshold = 4, above = 1, below = 0 }\n"
                        "y = { kind = 'sample', input = 'u', period = 0.1 }\n"
                        "z = { kind = 'sample', input = 'r', period = 0.1 }\n",
                    outputs = "[outputs]\ny = { unit = '1' }\nz = { unit = '1' }\n";
  folder.write("sampled.toml", blocks + outputs);
  folder.write("not.toml",
               blocks + "x = { kind = 'integrator', input = 'u' }\n" + outputs + "x = { unit = 's' }\n");
  const Program sampled = compile(read_diagram(folder.path() / "sampled.toml")),
                not_sampled = compile(read_diagram(folder.path() / "not.toml"));
  ASSERT_TRUE(sampled.sampled() && !not_sampled.sampled());
  Simulation a(sampled, nullptr, make_integrator({})), b(not_sampled, nullptr, make_integrator({}));
  a.start(0.0, false);
  b.start(0.0);
  const std::vector<double> expected{1, 1, 5, 5, 9};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const double t = 0.1 * static_cast<double>(k);
    a.act(t);
    if (k > 0) b.run(t);
    EXPECT_EQ(a.output(0), expected[k]) << k;
    EXPECT_EQ(b.output(0), expected[k]) << k;
    for (const Simulation* s : {&a, &b}) EXPECT_EQ(s->output(1), expected[k] > 4.0 ? 1.0 : 0.0) << k;
  }
}

TEST_F(Files, AreRefusedBeyondTheirTimes) {
  folder.write("u.csv", "time,u\n0,1\n0.5,3\n");
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"block 'y' of kind csv", "time is 0.7", "0 to 0.5", "beyond"},
                      [&] { at(0.7, "column = 'u'"); }));
}

TEST_F(Files, AreRefusedByPlace) {
  const auto code = ErrorCode::invalid_argument;
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words,
                           const std::string& keys = "column = 'u'") {
    folder.write("u.csv", text);
    return refuses(code, words, [&] { at(0.1, keys); });
  };
  EXPECT_TRUE(refused("time,v\n0,1\n1,1\n", {"d.toml:2", "u.csv: column 'u' is not there. There are: v"}));
  EXPECT_TRUE(refused("time,u\n0,1\n1,\n", {"u.csv:3", "column 'u' is empty"}));
  EXPECT_TRUE(refused("time,u\n0,1\n1,x\n", {"u.csv:3", "column 2"}));
  EXPECT_TRUE(refused("time,u\n1,1\n0,1\n", {"u.csv:3", "time falls"}));
  EXPECT_TRUE(refused("time,u\n0,1\n0,2\n", {"d.toml:2", "u.csv", "has one time"}));
  EXPECT_TRUE(refused("time,u\n0,1\n1,2\n", {"d.toml:2", "no column"}, "beyond = 'hold'"));
  EXPECT_TRUE(refused("time,u\n0,1\n1,2\n", {"beyond is 'extend'", "refuse, hold"},
                      "column = 'u', beyond = 'extend'"));
}

}  // namespace
}  // namespace tandem::engine
