// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/functions/library.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/mbs/functions/function_model.hpp"
#include "tandem/mbs/trajectory.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;

/// The library of tests/libraries/model_functions.c with that mistake.
std::string library(const std::string& mistake) {
  return std::string(TANDEM_TEST_LIBRARIES) + "/model_functions_" + mistake + ".so";
}

TEST(FunctionLibrary, AFreeMassFallsAlongItsParabola) {
  FunctionModel model(open_library(library("none")));
  EXPECT_EQ(model.info().name, "free_mass");
  EXPECT_EQ(model.info().variables, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(model.info().units, (std::vector<std::string>{"m", "cm"}));
  const Trajectory all = trajectory(model, model.initial(5.0), {}, 0.25, 8);
  EXPECT_EQ(all.time[8], 7.0);
  EXPECT_NEAR(all.q(8, 0), 1.0 + 3.0 * 2.0 + 2.0 * 2.0 * 2.0 / 2.0, 1e-12);  // the trapezoidal rule is exact
  EXPECT_NEAR(all.v(8, 0), 7.0, 1e-12);
  EXPECT_EQ(all.iterations, 8);
}

TEST(FunctionLibrary, TwoInstancesLiveSideBySide) {
  FunctionModel first(open_library(library("none"))), second(open_library(library("none")));
  EXPECT_EQ(first.info().q, second.info().q);
}

TEST(FunctionLibrary, RefusesAFileThatIsNone) {
  const test::Scratch folder;
  folder.write("text.so", "no library");
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"text.so"}, [&] { open_library(folder.path() / "text.so"); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"absent.so", "is not there"},
                      [&] { open_library(folder.path() / "absent.so"); }));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"tandem_model"}, [] { open_library(library("no_symbol")); }));
}

TEST(FunctionLibrary, RefusesATableThatItCannotUse) {
  const auto refuses_to_open = [](ErrorCode code, const char* mistake,
                                  const std::vector<std::string>& texts) {
    return refuses(code, texts, [&] { open_library(library(mistake)); });
  };
  EXPECT_TRUE(refuses_to_open(ErrorCode::not_supported, "version", {"version", "is 2", "allowed is 1"}));
  EXPECT_TRUE(refuses_to_open(ErrorCode::not_supported, "table", {"bytes", "or more"}));
  EXPECT_TRUE(refuses_to_open(ErrorCode::invalid_argument, "lacks_forces", {"lacks forces"}));
  EXPECT_TRUE(refuses_to_open(ErrorCode::invalid_argument, "no_info", {"info lacks"}));
  EXPECT_TRUE(refuses_to_open(ErrorCode::invalid_argument, "no_name", {"variable 2 has no name"}));
  EXPECT_TRUE(refuses_to_open(ErrorCode::invalid_argument, "create_fails",
                              {"create", "the sentence of the library"}));
}

TEST(FunctionLibrary, TellsWhichTermFailsAndWhen) {
  FunctionModel failing(open_library(library("forces_fail")));
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"forces at t = 1 s", "the sentence of the library"},
                      [&] { trajectory(failing, failing.initial(1.0), {}, 0.1, 1); }));
  FunctionModel infinite(open_library(library("not_finite")));
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"free_mass", "forces at t = 0 s is inf at (2, 1)"},
                      [&] { trajectory(infinite, infinite.initial(0.0), {}, 0.1, 1); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"mass has 0 at (1, 2) and 0.5 at (2, 1)", "symmetric"},
                      [] { FunctionModel(open_library(library("lopsided_mass"))); }));
}

TEST(Trajectory, RefusesAStepThatIsNone) {
  FunctionModel model(open_library(library("none")));
  for (const double step : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"allowed are 0 or more steps of a finite time"},
                        [&] { trajectory(model, model.initial(0.0), {}, step, 1); }));
}

}  // namespace
}  // namespace tandem::mbs
