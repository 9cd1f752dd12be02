// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "examples.hpp"
#include "mass2_library.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"

namespace tandem::test {
namespace {

/// The two-mass test with mass 2 from that source.
std::vector<Recording::Rows> two_masses(const std::string& slow_uri, const std::string& schedule) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", library_sources());
  const auto slow = open(slow_uri, library_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow).schedule(schedule);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(SharedLibrary, TwoMassesWithMass2InAnyLanguageGiveTheSameBits) {
  for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"}) {
    const auto expected = two_masses("builtin:two_mass.slow?frequency_ratio=30.7", schedule);
    for (const std::string& language : library_languages())
      EXPECT_TRUE(same_bits(two_masses(mass2_library(language) + mass2_parameters(30.7), schedule), expected))
          << language << ", " << schedule;
  }
}

/// Built with the headers of before held outputs, and of before declared parameters (tests/libraries), whose
/// tables are shorter.
TEST(SharedLibrary, OneThatWasBuiltBeforeRunsAsItDid) {
  for (const std::string library : {TANDEM_LIBRARY_OF_BEFORE, TANDEM_LIBRARY_OF_BEFORE_PARAMETERS}) {
    const std::string before = "lib:" + library + "?" + mass2_parameters(30.7);
    const auto info = open(before, library_sources())->info();
    EXPECT_FALSE(info.abilities.sampled || info.holds());
    EXPECT_TRUE(info.abilities.serializes_state);
    EXPECT_TRUE(info.parameters.empty());
    EXPECT_EQ(info.outputs[0].nominal, 1.0);
    for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"})
      EXPECT_TRUE(same_bits(two_masses(before, schedule),
                            two_masses("builtin:two_mass.slow?frequency_ratio=30.7", schedule)));
  }
}

/// It takes any, and refuses what it does not know in its own words.
TEST(SharedLibrary, OneThatWasBuiltBeforeRefusesAParameterItself) {
  for (const std::string library : {TANDEM_LIBRARY_OF_BEFORE, TANDEM_LIBRARY_OF_BEFORE_PARAMETERS})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                        {"create: 'colour=blue' begins with no parameter of m, k"},
                        [&] { open("lib:" + library + "?colour=blue", library_sources()); }));
}

TEST(SharedLibrary, ItsInstancesAreIndependentAndMayOutliveOneAnother) {
  const auto make = [] { return open(mass2_library("c") + mass2_parameters(), library_sources()); };
  auto first = make();
  const auto second = make();
  first.reset();
  std::vector<double> memory(static_cast<std::size_t>(second->info().row_size()));
  Samples y(memory.data(), second->info().row_size(), 1);
  const double u0 = 0.0;
  EXPECT_EQ(second->initialize(0.0, 1.0, {&u0, 1}, y).time, 0.0);
}

TEST(SharedLibrary, AnErrorOfALibraryIsItsOwnSentence) {
  for (const std::string& language : library_languages())
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"example_mass2_" + language, "needed"},
                        [&] { open(mass2_library(language) + "m=1", library_sources()); }));
}

}  // namespace
}  // namespace tandem::test
