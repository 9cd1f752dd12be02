// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models of subsystems that tell their states, and how often subsystems are opened for them.
#include "tandem/identification/models.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "long_run.hpp"
#include "scratch.hpp"
#include "tandem/identification/identify.hpp"
#include "tandem/identification/surrogate.hpp"

namespace tandem::models_tests {
namespace {

using namespace test;

identification::Wanted all_of(const SubsystemInfo& info, std::vector<double> inputs) {
  identification::Wanted wanted{0.0, std::move(inputs), {}, 400};
  for (int k = 0; k < info.row_size() - Samples::header; ++k) wanted.values.push_back(k);
  return wanted;
}

/// A chain of so many masses on the ground, pushed at its end.
std::string chain(int masses) {
  std::string coordinates, relations, springs;
  for (int k = 0; k < masses; ++k) {
    const std::string n = std::to_string(k);
    coordinates += "x" + n + " = { unit = 'm', inertia = 30 }\nd" + n + " = { unit = 'm' }\n";
    relations += "r" + n + " = { terms = { x" + n + " = 1, " +
                 (k > 0 ? "x" + std::to_string(k - 1) + " = -1, " : "") + "d" + n + " = -1 } }\n";
    springs += "s" + n + " = { coordinate = 'd" + n +
               "', stiffness = 50000, damping = " + std::to_string(20 + k) + " }\n";
  }
  const std::string last = "x" + std::to_string(masses - 1);
  return "dimension = 2\ngravity = [0, 0]\n[coordinates]\n" + coordinates + "[relations]\n" + relations +
         "[springs]\n" + springs + "[inputs]\nf = { unit = 'N' }\n[forces]\nf = { coordinate = '" + last +
         "', magnitude = 'f' }\n[outputs]\nx = { position = '" + last + "' }\nv = { velocity = '" + last +
         "' }\n[initial]\npositions = { " + last + " = 0.1 }\n";
}

/// Responses alone tell 24 states to 1e-5 only.
TEST(ModelsOfStates, AreAsExactOfManyStatesAsOfFew) {
  const Scratch folder;
  for (const int masses : {1, 3, 12}) {
    const auto file = folder.write("chain.toml", chain(masses));
    const auto one = open("mechanism:" + file.string() + "?step=2e-3", sources());
    const auto model = identification::identify_linear(*one, all_of(one->info(), {2.0}));
    ASSERT_TRUE(model) << masses;
    EXPECT_EQ(model->order(), 2 * masses);
    EXPECT_LT(model->residual, 1e-10) << masses;
  }
}

/// Its forces differ by 1e6, and follow inputs at once.
TEST(ModelsOfStates, AreExactWhereOutputsOfDifferentSizeFollowAtOnce) {
  const Scratch folder;
  const auto file = folder.write(
      "wheel.toml",
      "[inputs]\nX = { unit = 'm' }\nroad = { unit = 'm' }\n[blocks]\n"
      "up = { kind = 'sum', inputs = ['X', 'x'], gains = [1.6e-2, -1.6e-2] }\n"
      "down = { kind = 'sum', inputs = ['road', 'x'], gains = [1.8e5, -1.8e5] }\n"
      "a = { kind = 'sum', inputs = ['up', 'down', 'v'], gains = [0.025, 0.025, -0.5] }\n"
      "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v', initial = 0.01 }\n"
      "[outputs]\nup = { unit = 'N' }\ndown = { unit = 'N' }\n");
  const auto one = open("diagram:" + file.string() + "?step=2e-4", sources());
  const auto model = identification::identify_linear(*one, all_of(one->info(), {0.0, 0.02}));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->order(), 2);
  EXPECT_LT(model->residual, 1e-10);
  EXPECT_TRUE(model->d.isApprox(Eigen::Matrix2d{{1.6e-2, 0.0}, {0.0, 1.8e5}}, 1e-12)) << model->d;
}

/// Tells how many subsystems it has made.
Builtins counting(Builtins all, const std::string& scheme, std::atomic<int>& made) {
  Source& source = all.schemes.at(scheme);
  source.make = [&made, make = source.make](const Address& address, Parameters& parameters) {
    ++made;
    return make(address, parameters);
  };
  return all;
}

void begin(const std::string& file, const Settings& settings, const Builtins& builtins) {
  scenario::Assembly(scenario::read(file, settings), builtins).initialize();
}

std::string scene_of(const std::string& source) {
  return "[subsystems.a]\nsource = 'diagram:" + source + "'\nparameters.step = 1e-3\n" +
         "inputs = { u = 0 }\n[span]\nstop = 1\n";
}

const std::string low_pass =
    "[inputs]\nu = { unit = '1' }\n[blocks]\nrate = { kind = 'sum', inputs = ['u', 'y'], gains = [1, -1] }\n"
    "y = { kind = 'integrator', input = 'rate', initial = 1 }\n[outputs]\ny = { unit = '1' }\n";

TEST(Models, AreOpenedOnceForEachStep) {
  const Scratch folder;
  folder.write("d.toml", low_pass);
  const auto file = folder.write("s.toml", scene_of("d.toml")).string();
  std::atomic<int> made = 0;
  identification::Models models;
  const Builtins all = models.replacing(counting(sources(), "diagram", made));
  for (int k = 0; k < 5; ++k) begin(file, {}, all);
  EXPECT_EQ(made, 1);
  for (int k = 0; k < 5; ++k) begin(file, {"subsystems.a.parameters.step=5e-4"}, all);
  EXPECT_EQ(made, 2);
  for (const auto& one : models.stands()) EXPECT_TRUE(one.modelled) << one.why;
}

/// How it stands for a diagram with an input u.
identification::Stand stand_of(const std::string& diagram, double inputs = 0.0) {
  const Scratch folder;
  folder.write("d.toml", "[inputs]\nu = { unit = '1' }\n[outputs]\ny = { unit = '1' }\n[blocks]\n" + diagram);
  const auto file = folder.write("s.toml",
                                 "[subsystems.a]\nsource = 'diagram:d.toml'\nparameters.step = 1e-2\n"
                                 "inputs = { u = " +
                                     std::to_string(inputs) + " }\n[span]\nstop = 10\n");
  identification::Models models;
  begin(file.string(), {}, models.replacing(sources()));
  return models.stands().at(0);
}

TEST(Models, AreThereForWhatHasNoStates) {
  const auto stand = stand_of("y = { kind = 'gain', input = 'u', gain = 3 }\n", 2.0);
  EXPECT_TRUE(stand.modelled) << stand.why;
  EXPECT_EQ(stand.order, 0);
}

/// At rest with inputs that stay; its rate is another one between a quarter and half of the run.
TEST(Models, SeeRatesThatChangeInTheFirstHalf) {
  const auto stand = stand_of(
      "rate = { kind = 'table', input = 'time', x = [0, 4, 4.1, 20], y = [1, 1, 6, 6] }\n"
      "lost = { kind = 'product', inputs = ['rate', 'y'] }\n"
      "a = { kind = 'sum', inputs = ['u', 'lost'], gains = [1, -1] }\ny = { kind = 'integrator', input = 'a' "
      "}\n");
  EXPECT_FALSE(stand.modelled);
}

/// A stiff coordinate that no output tells of goes to and fro from step to step, and no motion in continuous time does.
TEST(Models, HaveStepsThatCanBeCutWhateverNoOutputTellsOf) {
  const Scratch folder;
  folder.write(
      "m.toml",
      "dimension = 2\ngravity = [0, 0]\n[coordinates]\nx = { unit = 'm', inertia = 1 }\n"
      "z = { unit = 'm', inertia = 1 }\n[springs]\nx = { coordinate = 'x', stiffness = 40, damping = 0.1 }\n"
      "z = { coordinate = 'z', stiffness = 1e8, damping = 2e5 }\n[inputs]\nf = { unit = 'N' }\n[forces]\n"
      "f = { coordinate = 'x', magnitude = 'f' }\n[outputs]\nx = { position = 'x' }\n"
      "[initial]\npositions = { x = 0.1 }\n");
  const auto file = folder.write("s.toml",
                                 "[subsystems.a]\nsource = 'mechanism:m.toml'\nparameters.step = 1e-2\n"
                                 "inputs = { f = 0 }\n[span]\nstop = 1\n");
  identification::Models models;
  const auto one = scenario::read(file, {});
  scenario::Assembly run(one, models.replacing(sources()));
  run.initialize();
  EXPECT_TRUE(models.stands().at(0).modelled) << models.stands().at(0).why;
  EXPECT_EQ(models.stands().at(0).order, 2);
}

/// A parameter of its own may be called like one that makes steps.
TEST(Models, OfOtherParametersAreNoKin) {
  const Scratch folder;
  folder.write(
      "d.toml",
      "[parameters]\nsteps_per_turn = { value = 0, unit = '1' }\n" + low_pass +
          "late = { unit = '1' }\n[blocks.load]\nkind = 'table'\ninput = 'time'\nx = [0, 0.9, 0.95, 2]\n"
          "y = [0, 0, 1, 1]\n[blocks.late]\nkind = 'gain'\ninput = 'load'\ngain = '$steps_per_turn'\n");
  const auto file = folder.write("s.toml", scene_of("d.toml")).string();
  identification::Models models;
  const Builtins all = models.replacing(sources());
  for (const char* gain : {"0", "20"})
    begin(file, {std::string("subsystems.a.parameters.steps_per_turn=") + gain}, all);
  ASSERT_EQ(models.stands().size(), 2U);
  EXPECT_TRUE(models.stands()[0].modelled) << models.stands()[0].why;
  EXPECT_FALSE(models.stands()[1].modelled);
}

/// Late in the run, when no response looks: at every step.
TEST(Models, ThatGoByTheirOwnClockAreNoneAtAnyStep) {
  const Scratch folder;
  folder.write("d.toml", low_pass +
                             "late = { unit = '1' }\n[blocks.late]\nkind = 'table'\ninput = 'time'\n"
                             "x = [0, 0.9, 0.95, 2]\ny = [0, 0, 1, 1]\n");
  const auto file = folder.write("s.toml", scene_of("d.toml")).string();
  identification::Models models;
  const Builtins all = models.replacing(sources());
  for (const char* step : {"1e-3", "5e-4", "2e-3"})
    begin(file, {std::string("subsystems.a.parameters.step=") + step}, all);
  ASSERT_EQ(models.stands().size(), 3U);
  for (const auto& one : models.stands()) {
    EXPECT_FALSE(one.modelled);
    EXPECT_NE(one.why.find("its own clock"), std::string::npos) << one.why;
  }
}

}  // namespace
}  // namespace tandem::models_tests
