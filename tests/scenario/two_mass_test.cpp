// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"
#include "tandem/text/time_table.hpp"
#include "two_mass/model.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;
using test::two_mass_file;
using text::TimeTable;

two_mass::Model model() {
  two_mass::Settings settings;
  settings.frequency_ratio = 25.0;
  return two_mass::Model(settings);
}

/// The position error of the thesis for x1, (FR/N) rms(x1 - x1_exact) / rms(x1), of a scenario's run.
double position_error(const std::string& file, std::vector<std::string> more = {}) {
  const Scratch folder;
  std::vector<std::string> arguments{"run", two_mass_file(file), "--output", "o", "--no-reference"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Said said = tandem(folder, arguments);
  EXPECT_EQ(said.status, 0) << said.err;
  const TimeTable table = TimeTable::read(folder.path() / "o");
  const two_mass::Model exact = model();
  double difference = 0.0, square = 0.0;
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    const double x1 = table.columns[0][k];
    difference += std::pow(x1 - exact.exact(table.times[k]).x1, 2);
    square += x1 * x1;
  }
  return 25.0 / 100.0 * std::sqrt(difference / square);
}

class TwoMassScenario : public testing::TestWithParam<const char*> {};

TEST_P(TwoMassScenario, RunsWithinItsReferenceAndPassesValidation) {
  const Scratch folder;
  Said said = tandem(folder, {"run", two_mass_file(GetParam())});
  EXPECT_EQ(said.status, 0) << said.err;
  said = tandem(folder, {"validate", two_mass_file(GetParam())});
  EXPECT_EQ(said.status, 0) << said.err;
}

INSTANTIATE_TEST_SUITE_P(All, TwoMassScenario,
                         testing::Values("two_mass.toml", "force_plain.toml", "force_memory.toml",
                                         "force_delay.toml", "real_loop_memory.toml", "monolithic.toml",
                                         "staggered.toml"),
                         [](const auto& test) { return std::filesystem::path(test.param).stem().string(); });

/// The file was rounded to 12 places; the formula rounds by some 1e-13 at t = 100 s.
TEST(TwoMassReference, IsTheExactMotion) {
  const TimeTable table = TimeTable::read(two_mass_file("exact_motion.csv"));
  const two_mass::Model exact = model();
  ASSERT_EQ(table.names, (std::vector<std::string>{"fast.x1", "slow.x2", "both.x1", "both.x2"}));
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    const auto motion = exact.exact(table.times[k]);
    for (const std::size_t column : {0U, 2U}) EXPECT_NEAR(table.columns[column][k], motion.x1, 2e-12);
    for (const std::size_t column : {1U, 3U}) EXPECT_NEAR(table.columns[column][k], motion.x2, 2e-12);
  }
}

/// The thesis' finding on a lag of the force where no loop needs one: by one step of the fast side,
/// practically as good as none; by one of the slow side (which its memory is), much worse. The card has the
/// figures: 1.94, 2.01 and 9.7 %.
TEST(TwoMassForce, AShortLagCostsLittleAndALongOneMuch) {
  const double plain = position_error("force_plain.toml");
  const double short_lag =
      position_error("force_delay.toml", {"--set", "coordination.communication_step=0.01"});
  const double long_lag = position_error("force_delay.toml"), memory = position_error("force_memory.toml");
  EXPECT_LT(plain, 0.02);
  EXPECT_NEAR(short_lag, plain, 0.05 * plain);
  EXPECT_GT(long_lag, 4.0 * plain);
  EXPECT_NEAR(memory, long_lag, 0.01 * long_lag) << "one own step of the reader is the communication step";
}

}  // namespace
}  // namespace tandem
