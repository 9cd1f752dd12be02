// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// FMUs of whole scenarios, against the same scenarios as one subsystem.
#include <gtest/gtest.h>

#include "exports.hpp"
#include "nested_scene.hpp"
#include "run_bench.hpp"
#include "tandem/exported/stepped_unit.hpp"

namespace tandem::test {
namespace {

using fmi::Version;

/// Outputs at the end of each step, the last of those of one time.
std::map<double, std::vector<double>> outputs_of(const std::vector<std::vector<double>>& rows, int outputs) {
  std::map<double, std::vector<double>> all;
  for (const auto& row : rows)
    all[row[0]] = {row.begin() + Samples::header, row.begin() + Samples::header + outputs};
  return all;
}

class ExportedScenario : public testing::Test {
 protected:
  ExportedScenario() { write_plant(exports.folder), write_three_masses(exports.folder); }
  std::string place(const char* file) const { return (exports.folder.path() / file).string(); }

  Exports exports;
};

TEST_F(ExportedScenario, GivesTheBitsOfTheScenarioWithItsInputsHeld) {
  const std::string folder = TANDEM_SOURCE_DIR "/scenarios/";
  const std::vector<std::pair<std::string, double>> scenes = {
      {place("drive.toml"), 1.0},
      {place("pair.toml"), 1.0},
      {folder + "chains/chains.toml", 10.0},
      {folder + "motor_crank/scene.toml", 0.2},
      {folder + "split_pendulum/split_pendulum.toml", 0.05},
      {folder + "engine_linkage/engine_linkage.toml", 0.2}};
  for (const auto& [file, stop] : scenes)
    for (const Version version : {Version::two, Version::three}) {
      SCOPED_TRACE(file);
      const auto fmu = Exports::open(exports.of(file, "x", version), "inputs=left");
      const auto source = open("scenario:" + file, file_sources());
      const std::vector<double> u(static_cast<std::size_t>(source->info().input_size()), 0.4);
      const int outputs = source->info().output_size();
      auto expected = outputs_of(FmuRun(*source, stop, u).rows, outputs),
           found = outputs_of(FmuRun(*fmu, stop, u).rows, outputs);
      EXPECT_GT(found.size(), 40U);
      EXPECT_EQ(found, expected);
    }
}

TEST_F(ExportedScenario, IsNoLargerThanTwoMegabytes) {
  EXPECT_LT(std::filesystem::file_size(exports.of(place("drive.toml"))), 2000000U);
}

TEST_F(ExportedScenario, HasItsOpenInputsConstantsAndParametersAsVariables) {
  const fmi::Archive archive(exports.of(place("pair.toml"), "x", Version::three));
  const auto d = fmi::read_description(archive.text("modelDescription.xml", 1 << 20), "x");
  std::string all;
  for (const fmi::Variable& v : d.variables) all += v.name + " " + v.start.value_or("-") + "; ";
  EXPECT_EQ(
      all,
      "time -; two.u 0; two.x -; der(two.x) -; three.x -; der(three.x) -; h 0.01; m3 1.5; two.m 2; two.k 3; "
      "two.s 5; two.x0 0; three.k 5; three.s 2; three.x0 0; extrapolate false; ");
  EXPECT_EQ(d.experiment.step, 0.01);
  const auto set = Exports::open(exports.of(place("pair.toml")), "inputs=left&set.m3=3&set.three.x0=1");
  const auto source = open("scenario:" + place("pair.toml") + "?m3=3&three.x0=1", file_sources());
  EXPECT_EQ(FmuRun(*set, 1.0, {0.0}).rows.back()[3], FmuRun(*source, 1.0, {0.0}).rows.back()[3]);
}

/// Two that differ by their start, each on what the other gives.
double coupled(const std::string& uri, const Builtins& sources, const std::string& set, double h,
               const std::string& how) {
  const std::string all = uri + "step=" + std::to_string(h) + "&" + set + "h=0.0025";
  const auto one = open(all, sources), other = open(all + "&" + set + "two.x0=1", sources);
  RunBench bench;
  bench.add("one", *one).add("other", *other);
  bench.connect("one.two.x", "other.two.u", how).connect("other.two.x", "one.two.u", how);
  return bench.run(2.0).rows(0).back()[2];
}

TEST_F(ExportedScenario, CoupledWithDerivativesOfInputsTheyErrAsTheScenariosDo) {
  const auto fmu = exports.of("scenario:" + place("pair.toml") + "?step=0.0025");
  const std::string source = "scenario:" + place("pair.toml") + "?";
  const double right = coupled(source, file_sources(), "", 0.0025, "lagrange3");
  for (const char* degree : {"1", "2"}) {
    const std::string how = std::string("lagrange") + degree,
                      import = "fmu:" + fmu.string() + "?inputs=derivatives&order=" + degree + "&";
    const double of_sources = std::abs(coupled(source, file_sources(), "", 0.04, how) - right),
                 found = std::abs(coupled(import, fmu_sources(), "set.", 0.04, how) - right);
    EXPECT_LT(found, 1.1 * of_sources) << how;
    EXPECT_GT(found, 0.9 * of_sources) << how;
  }
}

TEST_F(ExportedScenario, GoesOnFromItsStateWithTheSameBitsHereAndInAnotherInstance) {
  const auto resources = exports.unpacked(exports.of(place("drive.toml"), "drive"));
  exported::SteppedUnit one(resources), other(resources);
  const auto go = [](exported::SteppedUnit& unit, int from, int to) {
    std::vector<double> all;
    for (int k = from; k < to; ++k) {
      unit.set(1, std::sin(0.7 * k));
      if (k % 3 == 0) unit.set_derivative(1, 1, std::cos(0.7 * k));
      unit.step(0.0117 * k, 0.0117);
      for (std::size_t v = 0; v < unit.variables().size(); ++v)
        if (unit.variables()[v].kind == exported::Variable::Kind::output) all.push_back(unit.number(v));
    }
    return all;
  };
  go(one, 0, 13);
  const auto state = one.state();
  const auto expected = go(one, 13, 40);
  other.restore(state);
  EXPECT_EQ(go(other, 13, 40), expected);
  one.restore(state);
  EXPECT_EQ(go(one, 13, 40), expected);
}

/// Two rods that read accelerations of each other: an output follows the second derivative of an input at
/// once.
TEST(ExportedSystem, OfASplitPendulumErrsLittleThoughForcesFollowDerivatives) {
  const Exports exports;
  const std::string folder = TANDEM_SOURCE_DIR "/scenarios/split_pendulum/";
  const auto tip = [&](const std::string& one, const std::string& other, const Builtins& sources) {
    const auto upper = open(one, sources), lower = open(other, sources);
    RunBench bench;
    bench.add("upper", *upper).add("lower", *lower);
    for (const std::string axis : {"x", "y"}) {
      bench.connect("upper." + axis, "lower." + axis, "lagrange4");
      bench.connect("lower.a" + axis, "upper.a" + axis, "lagrange1");
      Connection force = connection("lower.R" + axis, "upper.F" + axis, "lagrange1", Lag::none);
      force.gain = -1.0;
      bench.topology.connect(force);
    }
    return bench.run(1.0).rows(1).back();
  };
  const auto expected =
      tip("mechanism:" + folder + "upper.toml", "mechanism:" + folder + "lower.toml", file_sources());
  const std::string derivatives = "?inputs=derivatives&order=2";
  const auto found =
      tip("fmu:" + exports.of(folder + "upper.toml", "upper").string() + derivatives,
          "fmu:" + exports.of(folder + "lower.toml", "lower").string() + derivatives, fmu_sources());
  const double peaks[] = {4.2, 8.2, 18.0, 20.0, 1.5, 1.5};  // of forces, accelerations and the tip
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found[2 + k], expected[2 + k], 3e-3 * peaks[k]) << k;
}

}  // namespace
}  // namespace tandem::test
