// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Linear models in the places of subsystems, and what is chosen by runs of them.
#include "tandem/advice/advice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "long_run.hpp"
#include "scratch.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/study/standing.hpp"
#include "tandem/study/sweep.hpp"

namespace tandem::advice_tests {
namespace {

using namespace test;

/// All samples of a run, one after another.
std::vector<double> rows_of(const scenario::Scenario& one, const Builtins& builtins) {
  scenario::Assembly run(one, builtins);
  test::Recording rows;
  run.coordinator().observe(&rows);
  run.initialize();
  while (run.coordinator().round()) {
  }
  std::vector<double> all;
  for (int i = 0; i < run.topology().size(); ++i)
    for (const auto& row : rows.rows(i)) all.insert(all.end(), row.begin(), row.end());
  return all;
}

struct Case {
  std::string file;
  Settings settings;
  double most;  ///< of the largest number
};

/// A step that is cut has an error of its own, which a model does not know.
TEST(Advice, ARunOfModelsIsThatOfTheSubsystems) {
  const std::vector<Case> cases = {
      {"two_mass/two_mass.toml", {}, 1e-7},
      {"two_mass/two_mass.toml", {"coordination.schedule=parallel", "parameters.frequency_ratio=30.7"}, 1e-4},
      {"two_mass/two_mass.toml",
       {"coordination.schedule=staggered", "connections.reconstruction=matched_hold"},
       1e-4},
      {"oscillator/force_displacement.toml", {}, 1e-7},
      {"oscillator/udc.toml", {"span.stop=1"}, 1e-7}};
  for (const auto& [file, settings, most] : cases) {
    const auto one = scene(file, settings);
    identification::Models models;
    const auto expected = rows_of(one, sources()), found = rows_of(one, models.replacing(sources()));
    for (const auto& stand : models.stands())
      EXPECT_TRUE(stand.modelled) << stand.source << ": " << stand.why;
    ASSERT_EQ(found.size(), expected.size()) << file;
    double off = 0.0, size = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k)
      off = std::max(off, std::abs(found[k] - expected[k])), size = std::max(size, std::abs(expected[k]));
    EXPECT_LT(off, most * size) << file;
  }
}

TEST(Advice, WhatHasNoLinearModelRunsItself) {
  const auto why = [](const std::string& file, const std::string& source) {
    identification::Models models;
    scenario::Assembly(scene(file, {}), models.replacing(sources())).initialize();
    for (const auto& stand : models.stands())
      if (stand.source == source) return stand.modelled ? "modelled" : stand.why;
    return std::string("not there");
  };
  EXPECT_EQ(why("split_pendulum/split_pendulum.toml", "mechanism:upper.toml"), "it is not linear");
}

TEST(Advice, RanksByErrorAndWithinOnePercentByCost) {
  const Scratch folder;
  const auto file =
      folder.write("schemes.csv",
                   "schedule,reconstruction,steps,error,reference_error,exchanges,own_steps,status,note\n"
                   "parallel,lagrange0,1,3,0.01,10,100,ok,\n"
                   "parallel,lagrange1,1,0.501,0.01,10,100,ok,\n"
                   "parallel,lagrange2,1,0.5,0.01,20,100,ok,\n"
                   "parallel,lagrange3,2,0.9,0.01,5,50,ok,\n"
                   "parallel,hermite,1,,,,,refused,no\n");
  const auto ranking = advice::ranking(file);
  ASSERT_EQ(ranking.choices.size(), 4U);
  EXPECT_EQ(ranking.others, 1U);
  EXPECT_EQ(ranking.choices[0].reconstruction, "lagrange1");
  EXPECT_EQ(ranking.choices[1].reconstruction, "lagrange2");
  EXPECT_EQ(ranking.choices[3].reconstruction, "lagrange0");
  ASSERT_TRUE(ranking.cheapest());
  EXPECT_EQ(ranking.cheapest()->reconstruction, "lagrange3");
}

TEST(Advice, SendsToTheEndWhatIsBetterThanAllThatIsCheaper) {
  const auto sent = [](const std::vector<std::pair<double, double>>& errors_and_exchanges) {
    advice::Ranking ranking;
    for (const auto& [error, exchanges] : errors_and_exchanges)
      ranking.choices.push_back({"parallel", "lagrange1", 1.0, error, exchanges, 1.0});
    std::vector<double> errors;
    for (const auto& one : advice::finalists(ranking)) errors.push_back(one.error);
    return errors;
  };
  EXPECT_EQ(sent({{0.1, 90}, {0.2, 95}, {0.3, 50}, {2, 20}, {3, 20}, {4, 30}, {12, 10}}),
            (std::vector<double>{2, 0.3, 0.1}));
  EXPECT_EQ(sent({{30, 90}, {40, 50}}), (std::vector<double>{30}));
}

/// By the standing study of models and that of the subsystems.
advice::Ranking ranking_of(const scenario::Scenario& one, const Builtins& builtins,
                           const Settings& settings) {
  const Scratch folder;
  const auto study = study::read(one.file, study::standing_study(one, sources()));
  study::Sweep(study, builtins, {folder.path(), settings, {}, 2}).run();
  return advice::ranking(folder.path() / "schemes.csv");
}

TEST(Advice, PredictsTheErrorsOfTheStandingStudy) {
  const Settings settings = {"parameters.frequency_ratio=9.3", "span.stop=20"};
  const auto one = scene("two_mass/two_mass.toml", settings);
  identification::Models models;
  const auto predicted = ranking_of(one, models.replacing(sources()), settings),
             found = ranking_of(one, sources(), settings);
  ASSERT_EQ(predicted.choices.size(), found.choices.size());
  ASSERT_GT(found.choices.size(), 30U);
  for (std::size_t k = 0; k < found.choices.size(); ++k) {
    EXPECT_EQ(predicted.choices[k].schedule, found.choices[k].schedule) << k;
    EXPECT_EQ(predicted.choices[k].reconstruction, found.choices[k].reconstruction) << k;
    EXPECT_NEAR(predicted.choices[k].error, found.choices[k].error, 1e-3 * found.choices[k].error + 1e-6)
        << k;
    EXPECT_EQ(predicted.choices[k].exchanges, found.choices[k].exchanges) << k;
  }
}

TEST(Advice, LinesMakeTheSchemeOfAChoice) {
  const auto one = scene("oscillator/udc.toml", {});
  const advice::Choice choice{"fastest-first", "lagrange4", 0.5, 0.0, 0.0, 0.0};
  const std::string text = advice::lines(choice, one, sources(), study::Varied::all);
  EXPECT_NE(text.find("schedule = \"fastest-first\""), std::string::npos) << text;
  EXPECT_NE(text.find("from = \"side2.x\"\nto = \"side1.x_other\"\nreconstruction = \"lagrange4\""),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("[subsystems.side1.parameters]\nstep = 0.0005"), std::string::npos) << text;
  EXPECT_NE(
      advice::reason(scenario::with_taken(one, advice::taken(choice, one, sources(), study::Varied::all)),
                     sources())
          .find("fastest mode"),
      std::string::npos);
}

/// A program tells none of its parameters, so one that is called step may make its step as any other does.
TEST(Advice, StepsOfAServedSourceAreScaled) {
  const Scratch folder;
  folder.write("lag.toml",
               "[blocks]\nx = { kind = 'integrator', input = 'rate', initial = 1 }\n"
               "rate = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = '1' }\n");
  auto one = scenario::read(folder.write("s.toml", "[subsystems.it]\ncommand = ['" TANDEM_COMMAND
                                                   "', 'serve', 'diagram:lag.toml']\n"
                                                   "parameters = { step = 0.01 }\n[span]\nstop = 1\n"));
  scenario::scale_steps(one, sources(), 0.5);
  EXPECT_EQ(std::get<double>(one.subsystems[0].parameters[0].value), 0.005);
}

/// A gain is no part of a scheme, and would be lost.
TEST(Advice, LinesKeepWhatAConnectionStates) {
  const auto one = scene("oscillator/udc.toml", {"connections[side1.x_other].gain=1.5"});
  const std::string text =
      advice::lines({"parallel", "lagrange1", 1.0, 0.0, 0.0, 0.0}, one, sources(), study::Varied::all);
  EXPECT_NE(text.find("to = \"side1.x_other\"\ngain = 1.5\nreconstruction = \"lagrange1\""),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace tandem::advice_tests
