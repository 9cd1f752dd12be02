// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Scilab as a partner, without a display.
#ifdef TANDEM_SCILAB_FOLDER
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "command.hpp"
#include "mass2_library.hpp"
#include "recording.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"

namespace tandem::test {
namespace {

std::string spawned_scilab(const std::string& file, const std::string& parameters) {
  return "spawn:env TANDEM_SCILAB_PROGRAM=" TANDEM_SCILAB_FOLDER " " TANDEM_SOURCE_DIR
         "/transports/scilab/run " +
         file + "?deadline=30&" + parameters;
}
const std::string mass2_of_scilab = TANDEM_SOURCE_DIR "/transports/examples/mass2.sce";

std::vector<Recording::Rows> run_beside_fast(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(ScilabPeer, TwoMassesWithMass2InScilabGiveTheSameBits) {
  EXPECT_TRUE(same_bits(run_beside_fast(spawned_scilab(mass2_of_scilab, mass2_parameters(30.7))),
                        run_beside_fast("builtin:two_mass.slow?frequency_ratio=30.7")));
}

/// Against the exact motion.
TEST(ScilabPeer, TheSceneIsWithinItsReference) {
  const Scratch folder;
  ::setenv("TANDEM_SCILAB_PROGRAM", TANDEM_SCILAB_FOLDER, 1);
  const Said said = tandem(
      folder, {"--quiet", "run", TANDEM_SOURCE_DIR "/scenarios/two_mass/scilab.toml", "--output", "r"});
  ::unsetenv("TANDEM_SCILAB_PROGRAM");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "r/results.csv"));
}

TEST(ScilabPeer, ParametersAreThoseOfTheScript) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"mass2.sce", "hello", "parameter 'k' is needed"},
                      [] { open(spawned_scilab(mass2_of_scilab, "m=1"), all_sources()); }));
}

/// The script with another line for one.
std::string changed(const Scratch& folder, const std::string& from, const std::string& to) {
  std::string text = read_text(mass2_of_scilab);
  text.replace(text.find(from), from.size(), to);
  return folder.write("m.sce", text);
}

TEST(ScilabPeer, AnErrorOfTheScriptIsOneSentence) {
  const Scratch folder;
  const std::string file = changed(folder, "push = p(2) * u(1, 3);", "push = p(99);");
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"Invalid index"},
                      [&] { run_beside_fast(spawned_scilab(file, mass2_parameters(30.7))); }));
}

TEST(ScilabPeer, WhatIsNoRealNumberIsNotTaken) {
  const Scratch folder;
  const std::string complex = changed(folder, "push = p(2) * u(1, 3);", "push = sqrt(-1);");
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"start or step gives no real numbers"},
                      [&] { run_beside_fast(spawned_scilab(complex, mass2_parameters(30.7))); }));
  const std::string of_step = changed(folder, "h = p(6);", "h = p(99);");
  EXPECT_THROW(
      {
        try {
          open(spawned_scilab(of_step, mass2_parameters()), all_sources());
        } catch (const Error& error) {
          EXPECT_NE(std::string(error.what()).find("Invalid index"), std::string::npos) << error.what();
          throw;
        }
      },
      Error);
}

TEST(ScilabPeer, AScilabThatEndsIsOneSentenceAndLeavesNothingBehind) {
  const Scratch folder;
  const Scratch temporary;  // Of this test alone: others run at the same time.
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  const std::string ends = changed(folder, "push = p(2) * u(1, 3);", "if t > 3 then exit(0); end; push = 0;");
  EXPECT_TRUE(refuses(ErrorCode::internal, {"Scilab has ended"},
                      [&] { run_beside_fast(spawned_scilab(ends, mass2_parameters(30.7))); }));
  const std::string none = changed(folder, "tandem_serve(model);", "exit(0);");
  EXPECT_THROW(open(spawned_scilab(none, mass2_parameters()), all_sources()), Error);
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
}

}  // namespace
}  // namespace tandem::test
#endif
