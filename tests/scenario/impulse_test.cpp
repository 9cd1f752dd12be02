// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// coordination.coupling = "impulse".
#include <gtest/gtest.h>

#include <cmath>

#include "scene_run.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::test {
namespace {

const std::string impulse_scene = two_mass_file("impulse.toml");

/// At ratio 300 a slow step takes three fast periods. Without the factor FR / N, which is 1 here.
TEST(ImpulseScenario, IsRightWhereTheSlowStepTakesFastPeriods) {
  const SceneRun coupled(impulse_scene);
  ASSERT_EQ(coupled.said().status, 0) << coupled.said().err;
  const SceneRun right(two_mass_file("exact.toml"), {"parameters.frequency_ratio=300", "span.stop=300"});
  const auto &x = coupled.column("fast.x1"), &exact = right.column("exact.x1");
  ASSERT_EQ(x.size(), exact.size());
  double errors = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
    errors += (x[k] - exact[k]) * (x[k] - exact[k]), squares += exact[k] * exact[k];
  EXPECT_LT(std::sqrt(errors / squares), 0.0025);
}

/// Few fast steps show where the force is continued; what goes to the slow side and back is no defect.
TEST(ImpulseScenario, HasTheIndicatorsOfTheFastSide) {
  const auto said = [](const char* steps) {
    return SceneRun(impulse_scene,
                    {std::string("parameters.steps_per_cycle=") + steps, "coordination.carrier=surrogate"})
        .said()
        .out;
  };
  for (const auto& [steps, defect] : {std::pair("100", "defect 0.0015 "), {"20", "defect 0.035 "}}) {
    EXPECT_TRUE(contains(said(steps), std::string(defect) + "of the input's peak (slow_surrogate.force"))
        << said(steps);
    EXPECT_TRUE(contains(said(steps), "(fast.F:slow_surrogate.displacement)")) << said(steps);
  }
}

/// The surrogate leads where an order does not say otherwise.
TEST(ImpulseScenario, TakesAnOrderOfTheSidesAlone) {
  const SceneRun whole(impulse_scene, {"span.stop=30"}),
      stated(impulse_scene, {"span.stop=30", "coordination.order=[\"slow\", \"fast\"]"});
  EXPECT_EQ(stated.column("fast.x1"), whole.column("fast.x1")) << stated.said().err;
}

/// By both carriers there is one: with reactive inputs it is that of the fast side.
TEST(ImpulseScenario, HasTheClockOfTheSurrogate) {
  const SceneRun beside(impulse_scene,
                        {"span.stop=9", "record.clock=slow_surrogate", "coordination.carrier=surrogate"}),
      along(impulse_scene, {"span.stop=9", "record.clock=slow_surrogate"});
  EXPECT_EQ(along.column("slow_surrogate.displacement").size(), 901U) << along.said().err;
  EXPECT_EQ(beside.column("slow_surrogate.displacement").size(), 901U) << beside.said().err;
}

/// By itself `reactive` where the fast side can; a note tells why not. Stated, it is refused.
TEST(ImpulseScenario, TakesTheCarrierThatItsSidesHave) {
  const auto notes = [](std::vector<std::string> settings) {
    settings.push_back("span.stop=9");
    const SceneRun run(impulse_scene, settings);
    EXPECT_EQ(run.said().status, 0) << run.said().err;
    return run.said().err;
  };
  EXPECT_TRUE(contains(notes({}), "'fast' integrates 'slow_surrogate' along"));
  EXPECT_FALSE(contains(notes({"coordination.carrier=surrogate"}), "along"));
  const std::string order = "coordination.order=[\"fast\", \"slow\"]";
  EXPECT_TRUE(
      contains(notes({order}), "carrier is surrogate, as coordination.order puts 'slow' ahead of 'fast'"));
  const Scratch folder;
  const Said refused =
      tandem(folder, {"run", impulse_scene, "--set", order, "--set", "coordination.carrier=reactive"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.err, "coordination.carrier is reactive, and coordination.order puts"))
      << refused.err;
}

/// Of the slow side's mass the fourth digit is off, or it is right.
TEST(ImpulseScenario, NotesAWrongEffectiveMassAtItsEnd) {
  const auto said = [](const char* mass) {
    const SceneRun run(impulse_scene, {"parameters.frequency_ratio=20", "span.stop=40",
                                       std::string("links[0].effective_mass=") + mass});
    EXPECT_EQ(run.said().status, 0) << run.said().err;
    return run.said().err;
  };
  const std::string note = "subsystem 'slow_surrogate': the slow side answers the force otherwise";
  EXPECT_TRUE(contains(said("2.572"), note));
  EXPECT_FALSE(contains(said("2.5647"), note));
}

/// At another start the modes go on from there; the errors are those of a run from 0.
TEST(ImpulseScenario, IsRightFromAnyStart) {
  for (const char* ratio : {"10", "20", "30", "40"}) {
    const std::string of = std::string("parameters.frequency_ratio=") + ratio;
    const std::vector<std::string> settings{of, "span.start=1000", "span.stop=1100"};
    const SceneRun coupled(impulse_scene, settings), right(two_mass_file("exact.toml"), settings);
    ASSERT_EQ(coupled.said().status, 0) << coupled.said().err;
    const auto &x = coupled.column("fast.x1"), &exact = right.column("exact.x1");
    double errors = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k)
      errors += (x[k] - exact[k]) * (x[k] - exact[k]), squares += exact[k] * exact[k];
    EXPECT_LT(std::stod(ratio) / 100.0 * std::sqrt(errors / squares), 0.0025) << ratio;
  }
}

/// Each side in a process of its own.
TEST(ImpulseScenario, HasTheSameBitsWhereverItsSidesAre) {
  const Scratch folder;
  const auto rows = [&](std::vector<std::string> settings) {
    std::vector<std::string> words{"run", impulse_scene, "--output", "o"};
    for (const std::string& one : settings) words.insert(words.end(), {"--set", one});
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 0) << said.err;
    return read_text(folder.path() / "o/results.csv");
  };
  const std::string here = rows({"span.stop=30"}),
                    serve = "=spawn:" TANDEM_COMMAND " serve builtin:two_mass.";
  EXPECT_EQ(rows({"span.stop=30", "subsystems.fast.source" + serve + "fast_force"}), here);
  EXPECT_EQ(rows({"span.stop=30", "subsystems.slow.source" + serve + "slow_force"}), here);
}

TEST(ImpulseScenario, TellsWhatOfTheFileItDoesNotUse) {
  const SceneRun run(impulse_scene, {"connections[slow.F].reconstruction=lagrange2", "span.stop=9"});
  EXPECT_TRUE(contains(run.said().err, "connection from fast.F to slow.F: lagrange2 is not used"))
      << run.said().err;
}

/// In place of the subsystem's own, which is 2.56 kg.
TEST(ImpulseScenario, TakesAStatedMass) {
  const SceneRun asked(impulse_scene, {"span.stop=30"}),
      stated(impulse_scene, {"span.stop=30", "links[0].effective_mass=5"});
  ASSERT_EQ(stated.said().status, 0) << stated.said().err;
  EXPECT_GT(std::abs(asked.last("fast.x1") - stated.last("fast.x1")), 1e-4);
}

/// With its stiffness stated `impulse` takes the better scheme; what is taken is told.
TEST(ImpulseScenario, TakesAStatedStiffness) {
  const std::string stated = "links[0].effective_stiffness=1.1222346e-3", short_run = "span.stop=30";  // k3
  const SceneRun plain(impulse_scene, {short_run}), stiff(impulse_scene, {short_run, stated}),
      named(impulse_scene, {short_run, stated, "coordination.coupling=impulse_stiffness"}),
      not_used(impulse_scene, {short_run, stated, "coordination.coupling=impulse_plain"});
  EXPECT_TRUE(contains(plain.said().err, "'slow' is coupled by impulse_plain")) << plain.said().err;
  EXPECT_TRUE(contains(stiff.said().err, "'slow' is coupled by impulse_stiffness")) << stiff.said().err;
  EXPECT_EQ(stiff.column("fast.x1"), named.column("fast.x1"));
  EXPECT_EQ(plain.column("fast.x1"), not_used.column("fast.x1"));
  EXPECT_NE(plain.column("fast.x1"), stiff.column("fast.x1"));
}

/// By a probe at the start: a spring of 1.12e-3 N/m at a ratio of 300, and of 0.114 at 30; no damper.
TEST(ImpulseScenario, FindsTheStiffnessThatIsNotStated) {
  for (const auto& [ratio, k3] : {std::pair("300", "1.1222346e-3"), std::pair("30", "0.11234705228031144")}) {
    const std::vector<std::string> found{"coordination.coupling=impulse_stiffness", "span.stop=60",
                                         std::string("parameters.frequency_ratio=") + ratio};
    std::vector<std::string> stated = found;
    stated.push_back(std::string("links[0].effective_stiffness=") + k3);
    const SceneRun probed(impulse_scene, found), told(impulse_scene, stated);
    ASSERT_EQ(probed.said().status, 0) << probed.said().err;
    const auto &a = probed.column("fast.x1"), &b = told.column("fast.x1");
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-6) << ratio;
  }
}

struct BadImpulse {
  std::string setting;
  std::vector<std::string> words;
};

/// Each setting alone.
void expect_refused(const std::string& scene, const std::vector<BadImpulse>& all) {
  const Scratch folder;
  for (const BadImpulse& bad : all) {
    const Said said = tandem(folder, {"run", scene, "--set", bad.setting});
    EXPECT_EQ(said.status, 2) << bad.setting << ": " << said.err;
    for (const std::string& word : bad.words)
      EXPECT_TRUE(contains(said.err, word)) << bad.setting << ": " << said.err;
  }
}

const std::string pushed_pendulum = std::string(TANDEM_SOURCE_DIR) + "/scenarios/pushed_pendulum/";

/// Beside both in one, of a pendulum whose effective mass varies by four times; with that of its start x1 is lost.
TEST(ImpulseScenario, FollowsAnEffectiveMassThatVaries) {
  const SceneRun right(pushed_pendulum + "reference.toml",
                       {"subsystems.whole.parameters.frequency_ratio=45", "span.stop=60"});
  const auto error = [&](const std::vector<std::string>& more) {
    std::vector<std::string> settings{"constants.ratio=45", "span.stop=60"};
    settings.insert(settings.end(), more.begin(), more.end());
    const SceneRun run(pushed_pendulum + "pushed_pendulum.toml", settings);
    EXPECT_EQ(run.said().status, 0) << run.said().err;
    const auto &x = run.column("fast.x1"), &exact = right.column("whole.x1");
    double errors = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k)
      errors += (x[k] - exact[k]) * (x[k] - exact[k]), squares += exact[k] * exact[k];
    return 0.75 * std::sqrt(errors / squares);
  };
  EXPECT_LT(error({}), 0.002);  // measured: 0.0012
  EXPECT_GT(error({"links[0].effective_mass=10.23"}), 0.1);
}

/// Gear teeth, a valve and a belt, at three phases. Measured: 0.18 %, 0.34 % and 0.042 %.
TEST(ImpulseScenario, OfFastSidesThatRattleIsRight) {
  const Scratch folder;
  const Said said = tandem(folder, {"sweep", TANDEM_SOURCE_DIR "/scenarios/rattling/study.toml", "--output",
                                    "o", "--where", "frequency_ratio == 100 && (coupling is impulse_plain)"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "9 rows, 9 ok")) << said.out;
  const auto table = charts::CsvTable::read(folder.path() / "o/rattling.csv", {"fast", "position_error"});
  for (std::size_t k = 0; k < table.size(); ++k)
    EXPECT_LT(table[k].number("position_error"), 0.005) << table[k].text("fast");
}

TEST(ImpulseScenario, RefusesAnAcceleranceThatIsNoneOfItsLink) {
  expect_refused(pushed_pendulum + "pushed_pendulum.toml",
                 {{"links[0].accelerance=fast.F", {"'fast.F'", "an output of 'slow'"}},
                  {"links[0].accelerance=[\"slow.x\", \"slow.x\"]", {"2 outputs", "1 links"}},
                  {"links[0].accelerance=slow.mass", {"no output", "'mass'"}},
                  {"links[0].accelerance=slow.x", {"x = 10,", "0.0977", "the same to 1e-6"}},
                  {"links[0].accelerance=3", {"an output, or an array of outputs"}}});
}

/// Where the mechanism lives in another process.
TEST(ImpulseScenario, HasTheSameBitsWithAnEffectiveMassThatVaries) {
  const Scratch folder;
  const std::string scene = pushed_pendulum + "pushed_pendulum.toml", served = TANDEM_COMMAND;
  const auto rows = [&](const std::string& to, std::vector<std::string> more) {
    more.insert(more.begin(), {"run", scene, "--output", to, "--set", "span.stop=40", "--set",
                               "coordination.coupling=impulse_plain"});
    const Said said = tandem(folder, more);
    EXPECT_EQ(said.status, 0) << said.err;
    return read_text(folder.path() / to / "results.csv");
  };
  const std::vector<std::string> told = {"--set", "subsystems.slow.parameters.accelerances=x.by.F", "--set",
                                         "links[0].accelerance=slow.x.by.F"};
  const std::string here = rows("here", {});
  EXPECT_EQ(rows("told", told), here);
  std::vector<std::string> served_too = told;
  served_too.insert(served_too.end(), {"--set", "subsystems.slow.source=spawn:" + served +
                                                    " serve mechanism:" + pushed_pendulum + "pendulum.toml"});
  EXPECT_EQ(rows("served", served_too), here);
}

TEST(ImpulseScenario, RefusesWhatItCantCouple) {
  const std::vector<BadImpulse> all{
      {"subsystems.slow.source=builtin:two_mass.slow", {"'slow' has no input of one number", "'F'"}},
      {"links[0].effort=fast.x1", {"'fast.x1' is read by no connection to 'slow'"}},
      {"connections[slow.F].memory=true", {"memory, delay or add"}},
      {"coordination.schedule=slowest-first", {"fastest-first"}},
      {"coordination.scheme=auto", {"coordination.scheme", "stated"}},
      {"coordination.order=[\"slow\", \"slow_surrogate\"]", {"'fast' is missing"}},
      {"subsystems.slow.land=always", {"land", "never"}},
      {"coordination.fast_period=0", {"coordination.fast_period", "above 0"}},
      {"links[0].effective_damping=1", {"effective_damping", "beside effective_stiffness"}},
  };
  expect_refused(impulse_scene, all);
}

/// The slow side would step with a force that is not known yet.
TEST(ImpulseScenario, EndsWhereTheSlowSideRunsAhead) {
  const Scratch folder;
  for (const char* order :
       {R"(["slow_surrogate", "slow", "fast"])", R"(["fast", "slow_surrogate", "slow"])"}) {
    const Said said = tandem(folder, {"run", impulse_scene, "--set", "coordination.carrier=surrogate",
                                      "--set", std::string("coordination.order=") + order});
    EXPECT_EQ(said.status, 1) << said.err;
    EXPECT_TRUE(contains(said.err, "the slow side stands at 3.000000 s")) << said.err;
  }
}

}  // namespace
}  // namespace tandem::test
