// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The scenes with diagrams of listed blocks alone, and with blocks in C++ in their place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

text::TimeTable run_of(const test::Scratch& scratch, const std::string& file,
                       const std::vector<std::string>& settings) {
  std::vector<std::string> words = {"run", TANDEM_SOURCE_DIR "/scenarios/" + file, "--output", "o"};
  for (const auto& s : settings) words.insert(words.end(), {"--set", "subsystems.engine.parameters." + s});
  const auto said = test::tandem(scratch, words);
  EXPECT_EQ(said.status, 0) << said.err;
  return text::TimeTable::read(scratch.path() / "o");
}

/// The largest difference of a column, relative to 1 or its size, or of the times, where events end steps.
double difference(const text::TimeTable& one, const text::TimeTable& other) {
  double most = one.times.size() == other.times.size() ? 0.0 : INFINITY;
  for (std::size_t k = 0; k < std::min(one.times.size(), other.times.size()); ++k)
    most = std::max(most, std::abs(one.times[k] - other.times[k]));
  for (std::size_t c = 0; c < one.columns.size(); ++c)
    for (std::size_t k = 0; k < std::min(one.times.size(), other.times.size()); ++k)
      most = std::max(most, std::abs(one.columns[c][k] - other.columns[c][k]) /
                                std::max(1.0, std::abs(one.columns[c][k])));
  return most;
}

void same_with(const std::string& file, const std::vector<std::string>& compiled, double rounding) {
  const test::Scratch listed, other;
  const auto one = run_of(listed, file, {});
  ASSERT_GT(one.times.size(), 100U);
  EXPECT_LT(difference(one, run_of(other, file, compiled)), rounding);
}

/// The engine's half turns are located to 1e-12 of a step, and flat positions make that larger.
TEST(CompiledScenes, TheLinkageIsDrivenAsByListedBlocks) {
  same_with("engine_linkage/engine_linkage.toml", {"manifold=../engine/manifold_compiled.toml"}, 1e-7);
}

TEST(CompiledScenes, TheKartIsDrivenAsByListedBlocks) {
  same_with("kart/kart.toml", {"engine=engine_compiled.toml", "gearbox=kart_automatic_compiled.toml"}, 1e-9);
}

}  // namespace
}  // namespace tandem
