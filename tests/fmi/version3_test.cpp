// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "changed_fmu.hpp"
#include "fmus.hpp"
#include "refusal.hpp"
#include "tandem/check.hpp"

namespace tandem::test {
namespace {

TEST(FmuOf3, DecayTakesItsOwnStepsOfEuler) {
  const auto fmu = open_fmu("decay3");
  const FmuRun run(*fmu, 10.0);
  ASSERT_EQ(run.rows.size(), 101U);
  for (std::size_t n = 0; n < run.rows.size(); ++n) EXPECT_NEAR(run.rows[n][2], std::pow(0.9, n), 1e-14);
}

TEST(FmuOf3, AStepThatItDoesNotTakeAndSaysItDoesEndsTheRun) {
  const auto fmu = open_fmu("decay3?step=0.05");
  EXPECT_TRUE(
      refuses(ErrorCode::numerical, {"from 0 to 0.05 s", "its own time is 0 s"}, [&] { FmuRun(*fmu, 1.0); }));
}

TEST(FmuOf3, DecayOfModelExchangeIsThatOf2) {
  const auto three = open_fmu("decay3?type=me&set.k=0.3&step=0.1"), two = open_fmu("decay?type=me&set.k=0.3");
  EXPECT_EQ(FmuRun(*three, 5.0).rows, FmuRun(*two, 5.0).rows);
}

/// A variable, or another name of one.
TEST(FmuOf3, AnyVariableIsAnOutputByItsName) {
  const auto fmu = open_fmu("decay3?outputs.x_again=true&outputs.der(x)=true&outputs.k=true");
  const auto& outputs = fmu->info().outputs;
  ASSERT_EQ(outputs.size(), 4U);
  EXPECT_EQ(outputs[1].name, "x_again");
  EXPECT_EQ(outputs[3].name, "k");
  EXPECT_TRUE(outputs[3].held);
  const auto row = FmuRun(*fmu, 1.0).rows.back();
  EXPECT_EQ(row[3], row[2]);
  EXPECT_EQ(row[4], -row[2]);
  EXPECT_EQ(row[5], 1.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'kk' is not there", "'k'"},
                      [] { open_fmu("decay?outputs.kk=true"); }));
}

/// Each bounce of Euler's steps of 10 ms that return at it, whatever the communication step.
TEST(FmuOf3, TheBallReturnsEarlyAtEachBounce) {
  std::vector<double> bounces;
  double h = 1.0, v = 0.0;
  for (int k = 1; k <= 200; ++k) {
    const double fallen = h;
    h += 0.01 * v, v += 0.01 * -9.81;
    if (h <= 0.0 && fallen > 0.0) bounces.push_back(0.01 * k), v *= -0.7, h = 0.0;
  }
  const auto fmu = open_fmu("ball3?type=cs&step=0.1");
  std::vector<double> found;
  const auto rows = FmuRun(*fmu, 2.0).rows;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (rows[k][1] == 0.0) continue;
    found.push_back(rows[k][0]);
    EXPECT_EQ(rows[k - 1][0], rows[k][0]);
    EXPECT_NEAR(rows[k][3], -0.7 * rows[k - 1][3], 1e-12);
  }
  ASSERT_GE(found.size(), 3U);
  ASSERT_EQ(found.size(), bounces.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], bounces[k], 1e-9);
}

TEST(FmuOf3, EachBounceOfModelExchangeIsWhereItIsInClosedForm) {
  const auto fmu = open_fmu("ball3?type=me");
  double t = std::sqrt(2.0 / 9.81), flight = 2.0 * t;
  int count = 0;
  for (const auto& row : FmuRun(*fmu, 2.3).rows) {
    if (row[1] != 1.0) continue;
    EXPECT_NEAR(row[0], t, 1e-9);
    t += flight *= 0.7, ++count;
  }
  EXPECT_GE(count, 6);
}

/// Time events are known before: steps of 0.3 s end at them.
TEST(FmuOf3, TheStairRisesAtItsTimesAndEndsTheRun) {
  for (const std::string type : {"cs", "me"}) {
    const auto fmu = open_fmu("stair3?step=0.3&type=" + type);
    const FmuRun run(*fmu, 10.0, {0.0});
    EXPECT_EQ(run.clock.stop, Stop::finished);
    EXPECT_EQ(run.clock.time, 4.0);
    int jumps = 0;
    for (const auto& row : run.rows) {
      const double before = std::ceil(row[0]) - (row[0] > 0.0 ? 1.0 : 0.0);
      EXPECT_EQ(row[2], row[1] == 1.0 ? row[0] : before) << row[0];
      jumps += row[1] == 1.0 ? 1 : 0;
    }
    EXPECT_EQ(jumps, 4) << type;
  }
}

/// Not those that they had in the mean over the step before.
TEST(FmuOf3, InputsAreThoseOfTheTimeAtAnEvent) {
  for (const std::string type : {"cs", "me"}) {
    const auto fmu = open_fmu("stair3?step=0.3&type=" + type);
    std::vector<double> memory(200);
    const double u0 = 0.0;
    Samples first(memory.data(), fmu->info().row_size(), 1);
    fmu->initialize(0.0, 10.0, {&u0, 1}, first);
    const Segment ramp{10.0, 0.0, {0.0, 1.0}};
    const Signal u(&ramp, 1, 1);
    for (const double time : {1.0, 2.0, 3.0}) {
      Samples y(memory.data(), fmu->info().row_size(), 20);
      EXPECT_EQ(fmu->advance(10.0, false, {&u, 1}, y).stop, Stop::event);
      EXPECT_EQ(y.time(y.size() - 1), time);
      EXPECT_EQ(y.values(y.size() - 1)[1], time) << type;
    }
  }
}

TEST(FmuOf3, EveryTypeGoesThrough) {
  for (const std::string type : {"cs", "me"}) {
    const auto fmu = open_fmu("types3?step=0.5&set.text=four&type=" + type);
    const auto rows = FmuRun(*fmu, 1.0, {0.1, 1.5, -3.0, 1.0, 2.0}).rows;
    const std::vector<double> expected = {1.0, 0.0, 0.1F, 1.5, -3.0, 1.0, 2.0, 1.0, 4.0};
    EXPECT_EQ(rows.back(), expected) << type;
  }
}

/// Those that types3 has not by itself.
TEST(FmuOf3, EveryTypeOfWholeNumberGoesThrough) {
  for (const std::string type : {"Int8", "UInt8", "UInt16", "Int32", "UInt32", "UInt64"}) {
    const Scratch scratch;
    const auto fmu =
        open(changed(scratch, describing, description_with("<Int16 ", "<" + type + " ", "types3"), "types3",
                     "binaries/x86_64-linux/types3.so") +
                 "?step=0.5",
             fmu_sources());
    EXPECT_EQ(FmuRun(*fmu, 1.0, {0.0, 0.0, 5.0, 0.0, 1.0}).rows.back()[4], 5.0) << type;
  }
}

/// Of an input that nobody drives.
TEST(FmuOf3, AStartValueThatIsSetIsThatOfThePort) {
  const auto info = [](const std::string& name) { return look_at(fmu_uri(name), fmu_sources(), {})->info; };
  EXPECT_EQ(info("mass3?set.u=0.25").inputs[0].start, 0.25);
  EXPECT_EQ(info("space3?set.u=3 3").inputs[0].start, 3.0);
  const Port differs = info("space3?set.u=1 2").inputs[0];
  EXPECT_EQ(differs.starts, (std::vector<double>{1.0, 2.0}));
  EXPECT_TRUE(std::isnan(differs.start));
}

TEST(FmuOf3, AValueOutOfRangeEndsTheRun) {
  for (const auto& [inputs, text] : std::vector<std::pair<std::vector<double>, std::string>>{
           {{0.0, 0.0, 6.0, 0.0, 1.0}, "'whole_in' is 6 at t = 0 s; allowed are whole numbers from -5 to 5"},
           {{1e300, 0.0, 0.0, 0.0, 1.0}, "'real_in' is 1e+300"},
           {{0.0, 0.0, 0.0, 0.0, 3.0},
            "'choice_in' is 3 at t = 0 s; allowed are whole numbers from 1 to 2"}}) {
    const auto fmu = open_fmu("types3?step=0.5");
    EXPECT_TRUE(refuses(ErrorCode::numerical, {text}, [&] { FmuRun(*fmu, 1.0, inputs); }));
  }
}

/// In event mode alone: an FMU that has one refuses them else.
TEST(FmuOf3, ADiscreteInputThatJumpsMakesAnEventOfCoSimulation) {
  const auto fmu = open_fmu("types3?type=cs&step=0.5");
  std::vector<double> memory(200);
  const auto stride = fmu->info().row_size();
  const std::vector<double> u0 = {0.0, 0.0, 0.0, 0.0, 1.0};
  Samples first(memory.data(), stride, 1);
  fmu->initialize(0.0, 2.0, u0, first);
  const JumpingInputs inputs(u0, 2, 0.5, 4.0, 2.0);
  Samples y(memory.data(), stride, 10);
  const Clock clock = fmu->advance(2.0, false, inputs.signals, y);
  EXPECT_EQ(clock.stop, Stop::event);
  ASSERT_EQ(y.size(), 2);
  EXPECT_EQ(y.time(1), 0.5);
  EXPECT_EQ(y.values(0)[2], 0.0);
  EXPECT_TRUE(y.jump(1));
  EXPECT_EQ(y.values(1)[2], 4.0);
}

/// Of two inputs the FMU asks for u within a step, and not for f.
TEST(FmuOf3, AnInputThatIsNotAskedForWithinAStepHasItsMean) {
  const auto end = [](const std::string& inputs, double slope) {
    const auto fmu = open_fmu("mass3?type=cs&step=0.1&inputs=" + inputs);
    std::vector<double> memory(200);
    const double u0[] = {0.5, 0.0};
    Samples first(memory.data(), fmu->info().row_size(), 1);
    fmu->initialize(0.0, 1.0, u0, first);
    const Segment u{1.0, 0.0, {0.5, slope}}, f{1.0, 0.0, {0.0, 1.0}};
    const std::vector<Signal> signals = {{&u, 1, 1}, {&f, 1, 1}};
    Samples y(memory.data(), fmu->info().row_size(), 20);
    fmu->advance(1.0, false, signals, y);
    return y.values(y.size() - 1)[0];
  };
  EXPECT_NEAR(end("intermediate", 0.0), end("mean", 0.0), 1e-15);
  EXPECT_GT(std::abs(end("intermediate", 1.0) - end("mean", 1.0)), 1e-6);
}

/// x' = A x + u by steps of RK4 in both kinds; sizes are set by name.
TEST(FmuOf3, ArraysHaveTheSizesThatAreSet) {
  for (const std::string type : {"cs", "me"}) {
    const auto two = open_fmu("space3?set.A=0 1 -1 0&set.x0=1 0&type=" + type);
    ASSERT_EQ(two->info().inputs[0].size, 2);
    ASSERT_EQ(two->info().outputs[0].size, 2);
    EXPECT_EQ(two->info().feedthrough.size(), 4U);
    const auto row = FmuRun(*two, 1.0, {0.0, 0.0}).rows.back();
    EXPECT_NEAR(row[2], 2.0 * std::cos(1.0), 1e-8) << type;
    EXPECT_NEAR(row[3], -2.0 * std::sin(1.0), 1e-8) << type;

    Opening numbers;  // as a scenario gives them
    numbers.parameters.set("set.A", -2.0), numbers.parameters.set("set.x0", 3.0);
    const auto one = open(fmu_uri("space3?set.n=1&type=" + type), fmu_sources(), std::move(numbers));
    ASSERT_EQ(one->info().outputs[0].size, 1);
    EXPECT_NEAR(FmuRun(*one, 1.0, {2.0}).rows.back()[2], 2.0 * (1.0 + 2.0 * std::exp(-2.0)) + 2.0, 1e-8)
        << type;
  }
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'set.A' is '1 2'", "4 numbers"},
                      [] { open_fmu("space3?set.A=1 2"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'set.x0' is '1 -'", "2 numbers"},
                      [] { open_fmu("space3?set.x0=1 -"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'set.n' is 3", "from 1 to 2"},
                      [] { open_fmu("space3?set.n=3"); }));
}

TEST(FmuOf3, KeepsTheContract) {
  const double unknown = std::nan("");
  for (const auto& [name, inputs] : std::vector<std::pair<std::string, std::vector<double>>>{
           {"decay3", {}},
           {"decay3?state=trust", {}},
           {"decay3?type=me&step=0.1", {}},
           {"mass3?type=cs&state=trust", {unknown, unknown}},
           {"mass3?type=cs&inputs=intermediate", {unknown, unknown}},
           {"mass3?type=me", {unknown, unknown}},
           {"ball3?type=cs&state=trust", {}},
           {"ball3?type=me&step=0.01", {}},
           {"stair3?type=cs", {unknown}},
           {"space3?type=cs", {unknown, unknown}},
           {"space3?type=me", {unknown, unknown}},
           {"types3?type=cs&step=0.001", {0.0, 0.0, 1.0, 0.0, 1.0}},
           {"types3?type=me&step=0.001", {0.0, 0.0, 1.0, 0.0, 1.0}}})
    for (const Finding& finding : check([&, n = name] { return open_fmu(n); }, {0.5, inputs}))
      EXPECT_NE(finding.kind, Finding::Kind::wrong)
          << name << ": " << finding.check << ": " << finding.sentence;
}

}  // namespace
}  // namespace tandem::test
