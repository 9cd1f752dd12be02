// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// FMUs of Model Exchange by the integrators of SUNDIALS.
#include <gtest/gtest.h>

#include <cmath>

#include "changed_fmu.hpp"
#include "fmus.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "tandem/sources/integrators.hpp"

namespace tandem::test {
namespace {

const std::vector<std::string> adaptive = {"cvode_adams", "cvode_bdf", "erkstep", "arkstep"};

std::unique_ptr<Subsystem> open_at(const std::string& uri) {
  Builtins builtins;
  add_fmi(builtins, {}, {integrator_words(), take_integrator});
  return open(uri, builtins);
}

std::unique_ptr<Subsystem> open_adaptive(const std::string& name) { return open_at(fmu_uri(name)); }

std::string tight(const std::string& integrator) {
  return "integrator=" + integrator + "&relative_tolerance=1e-11&absolute_tolerance=1e-12";
}

TEST(FmuByItsTolerance, DecayIsRightAtEachRow) {
  for (const std::string& integrator : adaptive) {
    const auto rows = FmuRun(*open_adaptive("decay?type=me&" + tight(integrator)), 10.0).rows;
    ASSERT_EQ(rows.size(), 101U) << integrator;
    for (const auto& row : rows) EXPECT_NEAR(row[2], std::exp(-row[0]), 1e-8) << integrator << " " << row[0];
  }
}

TEST(FmuByItsTolerance, VanDerPolIsRight) {
  const double right = van_der_pol_at(20.0);
  for (const std::string& integrator : adaptive)
    EXPECT_NEAR(
        FmuRun(*open_adaptive("van_der_pol?type=me&step=0.1&" + tight(integrator)), 20.0).rows.back()[2],
        right, 2e-8)
        << integrator;
}

/// By its root finding: each flight is e times as long as the one before.
TEST(FmuByItsTolerance, EachBounceOfTheBallIsWhereItIsInClosedForm) {
  for (const std::string& integrator : adaptive) {
    const FmuRun run(*open_adaptive("ball?" + tight(integrator)), 2.3);
    EXPECT_LT(error_of_bounces(run.rows), 1e-8) << integrator;
  }
}

TEST(FmuByItsTolerance, TimeEventsEndItsSteps) {
  for (const std::string& integrator : adaptive) {
    const FmuRun run(*open_adaptive("stair?step=0.3&integrator=" + integrator), 10.0);
    EXPECT_EQ(run.clock.stop, Stop::finished);
    EXPECT_EQ(run.clock.time, 4.0);
  }
}

/// m x'' = k (u - x) - s x - d x' on an input that jumps within a call, and bends at its pieces.
TEST(FmuByItsTolerance, StopsWhereAnInputJumpsOrBends) {
  const auto rest = [](const std::string& parameters, const Builtins& sources) {
    const auto fmu = open(fmu_uri("mass?type=me&" + parameters), sources);
    const auto stride = fmu->info().row_size();
    std::vector<double> memory(static_cast<std::size_t>(stride) * 30000), u0 = {0.0};
    const Segment pieces[] = {
        {0.31417, 0.0, {0.0, 1.0}}, {0.72219, 0.31417, {0.31417, -2.0}}, {2.0, 0.72219, {1.5}}};
    Segment marked[3] = {pieces[0], pieces[1], pieces[2]};
    mark_jump(marked[2], true);
    const Signal u(marked, 3, 1);
    Samples first(memory.data(), stride, 1), y(memory.data(), stride, 30000);
    fmu->initialize(0.0, 2.0, u0, first);
    while (fmu->advance(2.0, true, {&u, 1}, y).time < 2.0) {
    }
    return y.values(y.size() - 1)[0];
  };
  Builtins sundials;
  add_fmi(sundials, {}, {integrator_words(), take_integrator});
  const double right = rest("step=1e-4", fmu_sources());
  for (const std::string& integrator : adaptive)
    EXPECT_NEAR(rest("step=0.05&" + tight(integrator), sundials), right, 1e-8) << integrator;
}

/// x'' = (u - x) - x, from x = 1 at rest, with itself as the other side: both are cos t.
TEST(FmuByItsTolerance, CoupledErrsAsTheSchemeDoes) {
  const auto error = [](const std::string& parameters, double h) {
    const std::string uri = "mass?type=me&step=" + std::to_string(h) + "&" + parameters;
    const auto one = open_adaptive(uri), other = open_adaptive(uri);
    RunBench bench;
    bench.add("one", *one).add("other", *other);
    bench.connect("one.x", "other.u", "lagrange3").connect("other.x", "one.u", "lagrange3");
    return std::abs(bench.run(2.0).rows(0).back()[2] - std::cos(2.0));
  };
  for (const char* integrator : {"cvode_adams", "cvode_bdf"}) {
    const double coarse = error(tight(integrator), 0.08), fine = error(tight(integrator), 0.02);
    EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 4.0, 0.2) << integrator << " " << coarse << " " << fine;
  }
}

/// Steps as long as those of the FMU, of order 4.
TEST(FmuByItsTolerance, ItsFixedStepsAreOfOrder4) {
  const auto error = [](double h) {
    const auto fmu = open_adaptive("decay?type=me&integrator=erkstep_fixed&step=" + std::to_string(h));
    return std::abs(FmuRun(*fmu, 2.0).rows.back()[2] - std::exp(-2.0));
  };
  EXPECT_NEAR(std::log2(error(0.1) / error(0.025)) / 2.0, 4.0, 0.3);
}

TEST(FmuByItsTolerance, KeepsItsPastToItself) {
  EXPECT_TRUE(open_fmu("decay?type=me")->info().abilities.saves_state);
  EXPECT_FALSE(open_adaptive("decay?type=me&integrator=cvode_bdf")->info().abilities.saves_state);
  EXPECT_TRUE(open_adaptive("types?type=me&step=0.1&integrator=cvode_bdf")->info().abilities.saves_state);
  EXPECT_TRUE(open_adaptive("decay?type=me&integrator=rk4")->info().abilities.saves_state);
}

/// A tolerance of 2^-16 of a state whose size is 2^-10 is one of 2^-26.
TEST(FmuByItsTolerance, NominalsScaleTheTolerance) {
  const Scratch scratch;
  const std::string small = changed(
      scratch, describing, description_with(R"(start="1"/>)", R"(start="1" nominal="0.0009765625"/>)"));
  const auto end = [](const std::string& uri, const std::string& tolerance) {
    const auto fmu = open_at(uri + "?type=me&integrator=cvode_bdf&relative_tolerance=1e-12&" + tolerance);
    return FmuRun(*fmu, 2.0).rows.back()[2];
  };
  const double scaled = end(small, "absolute_tolerance=1.52587890625e-05");
  EXPECT_EQ(scaled, end(fmu_uri("decay"), "absolute_tolerance=1.490116119384765625e-08"));
  EXPECT_EQ(scaled, end(small, "absolute_tolerance.x=1.490116119384765625e-08"));
  EXPECT_NE(scaled, end(fmu_uri("decay"), "absolute_tolerance=1.52587890625e-05"));
}

TEST(FmuByItsTolerance, RefusesWhatIsNone) {
  const auto refused = [](const std::string& parameters, const std::vector<std::string>& words) {
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, words, [&] { open_adaptive("decay?" + parameters); }));
  };
  refused("type=me&integrator=euler", {"integrator 'euler'", "cvode_bdf"});
  refused("type=me&integrator=cvode_bdf&relative_tolerance=0", {"relative_tolerance is 0", "above 0"});
  refused("type=me&integrator=cvode_bdf&absolute_tolerance.y=1e-9", {"absolute_tolerance.y", "state"});
  refused("type=me&integrator=erkstep_fixed&relative_tolerance=1e-9", {"erkstep_fixed", "leave them out"});
  refused("type=cs&integrator=cvode_bdf", {"'integrator'"});
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'integrator'"},
                      [] { open_fmu("decay?type=me&integrator=cvode_bdf"); }));
}

}  // namespace
}  // namespace tandem::test
