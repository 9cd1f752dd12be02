// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The models of scenarios/engine against the tables of their specification and what must hold of them.
#include <gtest/gtest.h>

#include <cmath>

#include "engine_files.hpp"
#include "refusal.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::engine {
namespace {

using test::engine_file;
using test::EngineRun;
using test::refuses;
using test::rpm;

/// Torque at a plate angle and a speed, which a crank of 1e9 kg m^2 keeps. After 5 s the manifold, whose
/// pressure settles within some tenths of a second, has long done so. At 50 deg its rate is 1000/s, which a
/// step of rk4 has to stand.
double steady_torque(const std::string& file, double theta, double speed) {
  EngineRun engine(engine_file(file, {{"J", 1e9}, {"N0", speed}, {"P0", 0.5}}), {theta, 0.0});
  engine.run(5.0);
  return engine["torque"];
}

/// As printed, +- 1 in the last digit.
TEST(EngineModels, HaveTheSteadyTorqueMap) {
  const auto map =
      charts::CsvTable::read(TANDEM_SOURCE_DIR "/scenarios/engine/printed_torque_map.csv", {});
  ASSERT_EQ(map.size(), 40U);
  for (std::size_t k = 0; k < map.size(); ++k) {
    const double speed = map[k].number("rpm"), theta = map[k].number("throttle");
    for (const char* file : {"engine.toml", "engine_mean_value.toml"}) {
      const double torque = steady_torque(file, theta, speed * std::numbers::pi / 30.0);
      EXPECT_NEAR(std::round(10.0 * torque) / 10.0, map[k].number("torque"), 0.1 + 1e-9)
          << file << ", " << speed << " rpm, " << theta << " deg";
    }
  }
}

/// Its speed settles at what is asked for after the step from 2000 to 3000 rpm at 5 s, under a load that
/// changes at 2 and 8 s; the plate stays within its range.
TEST(EngineModels, TheGovernorTakesTheEngineFrom2000To3000Rpm) {
  Description d = engine_file("governed_engine.toml");
  d.inputs.clear();
  d.blocks.push_back(
      {"set", "step", {{"time", 5.0}, {"before", 209.43951023931953}, {"after", 314.1592653589793}}});
  d.blocks.push_back({"less", "step", {{"time", 2.0}, {"before", 25.0}, {"after", 20.0}}});
  d.blocks.push_back({"more", "step", {{"time", 8.0}, {"after", 5.0}}});
  d.blocks.push_back({"load", "sum", {{"inputs", std::vector<Wire>{"less", "more"}}}});
  EngineRun run(d);
  double highest = 0.0, widest = 0.0;
  for (int k = 1; k <= 1500; ++k) {
    run.run(0.01 * k);
    highest = std::max(highest, rpm(run["N"]));
    widest = std::max(widest, run["throttle"]);
    EXPECT_GE(run["throttle"], 0.0);
    if (k == 499) {
      EXPECT_NEAR(rpm(run["N"]), 2000.0, 10.0);
    }
    if (k == 799) {
      EXPECT_NEAR(rpm(run["N"]), 3000.0, 10.0);
    }
  }
  EXPECT_NEAR(rpm(run["N"]), 3000.0, 1.0);
  EXPECT_LT(highest, 3300.0);
  EXPECT_GT(widest, 14.0);
  EXPECT_LE(widest, 50.0);
}

/// Half turns each 0.01 s, 300 rad/s asked for, 200 there up to 10 s, then 320: the integral comes to 50 deg
/// at 5.7 s, waits there, and goes down from there at once.
TEST(EngineModels, TheGovernorDoesNotWindUp) {
  Description d = engine_file("governor.toml");
  d.inputs.clear();
  d.blocks.push_back({"set", "constant", {{"value", 300.0}}});
  d.blocks.push_back({"N", "step", {{"time", 10.0}, {"before", 200.0}, {"after", 320.0}}});
  d.blocks.push_back({"half_turn", "sine", {{"amplitude", 1.0}, {"frequency", 100.0}, {"phase", 0.1}}});
  EngineRun run(d);
  run.run(2.0);
  EXPECT_NEAR(run["throttle"], 8.97 + 6.14 + 7.23 * 2.0, 7.23 * 0.011);
  run.run(9.9);
  EXPECT_EQ(run["throttle"], 50.0);
  run.run(12.0);
  EXPECT_NEAR(run["throttle"], 50.0 - 1.228 - 1.446 * 2.0, 1.446 * 0.011);
}

/// Torques of the converter at an engine's and a turbine's speed.
struct Converter {
  double impeller, output;
};
Converter converter(double N, double turbine, double fill = 1.0) {
  const EngineRun run(engine_file("converter.toml"), {N, turbine, fill});
  return {run["impeller"], run["output"]};
}

TEST(EngineModels, TheConverterHasItsCharacteristic) {
  EXPECT_NEAR(converter(200, 0).impeller, 5.34e-4 * 4e4, 1e-12);
  EXPECT_NEAR(converter(200, 0).output, 2.2 * 5.34e-4 * 4e4, 1e-12);
  EXPECT_NEAR(converter(200, 100).output, 1.5 * 5.34e-4 * (1 - 1 / 64.0) * 4e4, 1e-12);
  EXPECT_NEAR(converter(200, 190).output, converter(200, 190).impeller, 1e-12);
  EXPECT_NEAR(converter(100, 200).impeller, -5.34e-4 * (1 - 1 / 64.0) * 4e4, 1e-12);
  EXPECT_NEAR(converter(100, 200).output, -5.34e-4 * (1 - 1 / 64.0) * 4e4, 1e-12);
  EXPECT_NEAR(converter(200, 100, 0.25).impeller, 0.25 * converter(200, 100).impeller, 1e-12);
  EXPECT_EQ(converter(200, -5).output, converter(200, 0).output)
      << "its fit has no turbine that runs backwards";
}

/// What goes out at one side is never more than what comes in at the other.
TEST(EngineModels, TheConverterNeverMakesPower) {
  for (double N = 1.0; N <= 640.0; N += 21.3)
    for (double turbine = 0.0; turbine <= 800.0; turbine += 17.7)
      for (const double fill : {0.0, 0.3, 1.0}) {
        const Converter c = converter(N, turbine, fill);
        EXPECT_GE(c.impeller * N - c.output * turbine, -1e-9) << N << " " << turbine << " " << fill;
      }
}

/// The power lost in gearbox and final drive, with the gear in change at every fill and ratio.
TEST(EngineModels, AShiftAlwaysDissipates) {
  for (const char* file : {"kart_automatic.toml", "clutch_gearbox.toml"})
    for (const double N : {100.0, 200.0, 400.0})
      for (const double shaft : {0.0, 30.0, 90.0, 250.0}) {
        EngineRun box(engine_file(file), {N, shaft, 20.0, 5.0});  // it goes up twice
        double gear = 0.0;
        for (int k = 1; k <= 120; ++k) {
          box.run(0.01 * k);
          EXPECT_GE(box["load"] * N - box["torque"] * shaft, -1e-9) << file << " " << N << " " << shaft;
          gear = std::max(gear, box["gear"]);
        }
        EXPECT_EQ(gear, 3.0);
      }
}

/// Ratio and fill of a change of gear from 2.393 to 1.45.
TEST(EngineModels, AChangeOfGearIsAHoleAndARise) {
  EngineRun box(engine_file("kart_automatic.toml"),
                {200.0, 50.0, 8.0, 5.0});  // up at 0.08 s, once up to 9 m/s
  const struct {
    double after, ratio, fill;
  } course[] = {
      {-0.01, 2.393, 1.0}, {0.05, 1.9215, 0.0}, {0.1, 1.45, 0.0}, {0.16, 1.45, 0.5}, {0.22, 1.45, 1.0}};
  for (const auto& at : course) {
    box.run(0.08 + at.after, 1e-3);
    EXPECT_NEAR(box["ratio"], at.ratio, 1e-9) << at.after;
    EXPECT_NEAR(box["fill"], at.fill, 1e-9) << at.after;
  }
}

/// The clutch grips from 1200 rpm on and lets the engine go while a gear is changed.
TEST(EngineModels, TheClutchGripsFrom1200Rpm) {
  const auto torque = [](double rpm, double inner) {
    return EngineRun(engine_file("clutch.toml"), {rpm * std::numbers::pi / 30.0, inner, 1.0})["torque"];
  };
  EXPECT_EQ(torque(1100, 0), 0.0);
  EXPECT_NEAR(torque(1600, 0), 45.0, 1e-9);
  EXPECT_NEAR(torque(2400, 0), 90.0, 1e-9);
  EXPECT_NEAR(torque(2400, 80.0 * std::numbers::pi - 1.0), 45.0, 1e-9) << "1 rad/s of slip";
  EXPECT_NEAR(torque(2400, 400), -90.0, 1e-9);
}

Description with_law(const std::string& values) {
  return read_diagram("law", "[blocks]\ntheta = { kind = 'piecewise_linear', times = [0, 1, 2], values = " +
                                 values + ", low = 0, high = 50 }\n[outputs]\ntheta = { unit = 'deg' }\n");
}

TEST(EngineModels, ThrottleLawsStayWithinThePlatesRange) {
  const auto refused = [](const std::string& values, const std::string& what) {
    return refuses(ErrorCode::invalid_argument, {"law:2", "'theta'", what, "0 to 50"},
                   [&] { compile(with_law(values)); });
  };
  EXPECT_NO_THROW(compile(with_law("[0, 50, 3]")));
  EXPECT_TRUE(refused("[0, 51, 3]", "51"));
  EXPECT_TRUE(refused("[0, -1, 3]", "-1"));
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"manifold.throttle", "above 50", "t = 0 s", "0 to 50 deg"}, [] {
    EngineRun(engine_file("engine.toml"), {51.0, 20.0}).run(0.1);
  }));
}

TEST(EngineModels, GearThresholdsOutOfOrderAreRefused) {
  const auto gears = [](const std::string& up, const std::string& down,
                        const std::string& x = "[0, 10, 25]") {
    return "[inputs]\nv = { unit = 'm/s' }\nthrottle = { unit = 'deg' }\n[blocks]\n"
           "up = { kind = 'table', input = 'throttle', x = " +
           x + ", y = " + up +
           " }\n"
           "down = { kind = 'table', input = 'throttle', x = [0, 5, 25], y = " +
           down +
           " }\n"
           "[blocks.gear]\nkind = 'machine'\nstates = ['low', 'high']\ntransitions = [\n"
           "{ from = 'low', to = 'high', input = 'v', above = 'up' },\n"
           "{ from = 'high', to = 'low', input = 'v', below = 'down' } ]\n[outputs]\ngear = { unit = '1' }\n";
  };
  const auto code = ErrorCode::invalid_argument;
  EXPECT_NO_THROW(compile(read_diagram("g", gears("[4, 6, 8]", "[2, 3, 5]"))));
  EXPECT_TRUE(refuses(code, {"g:11", "from 'low' to 'high' is 5 at 5 of their tables", "above 5.5"},
                      [&] { compile(read_diagram("g", gears("[4, 6, 8]", "[2, 5.5, 5]"))); }));
  EXPECT_TRUE(refuses(code, {"g:11", "is 6 at 10", "above 6"},
                      [&] { compile(read_diagram("g", gears("[6, 6, 8]", "[2, 6, 6]"))); }));
  EXPECT_TRUE(refuses(code, {"g:5", "5 after 10", "ascends"},
                      [&] { compile(read_diagram("g", gears("[4, 6, 8]", "[2, 3, 5]", "[0, 10, 5]"))); }));
}

/// An engine with more load than it has torque.
TEST(EngineModels, AStallEndsWithASentenceOrRunsOnAsTheParameterSays) {
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"crank.stall", "below 30", "the engine has stalled"}, [] {
    EngineRun(engine_file("engine.toml"), {5.0, 60.0}).run(2.0);
  }));
  std::vector<std::string> told;
  const SimulationSettings settings{.tell = [&](const std::string& what) { told.push_back(what); }};
  EngineRun warned(engine_file("engine.toml", {{"stall", "warn"}}), {5.0, 60.0}, {}, settings);
  warned.run(1.0);
  EXPECT_LT(warned["N"], 30.0);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_NE(told[0].find("crank.range"), std::string::npos) << told[0];
  EXPECT_NE(told[1].find("the engine has stalled"), std::string::npos) << told[1];
  told.clear();
  EngineRun ignored(engine_file("engine.toml", {{"stall", "ignore"}}), {5.0, 60.0}, {}, settings);
  ignored.run(1.0);
  EXPECT_EQ(told.size(), 1U);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'stall' is 'perhaps'", "stop, warn, ignore"}, [] {
    engine_file("engine.toml", {{"stall", "perhaps"}});
  }));
}

}  // namespace
}  // namespace tandem::engine
