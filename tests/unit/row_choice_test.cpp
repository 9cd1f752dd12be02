// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/row_choice.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "recorder_bench.hpp"
#include "scratch.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

using test::read_text;
using test::RecorderBench;
using test::Scratch;
using text::TimeTable;

std::vector<double> times_of(const std::string& file) { return TimeTable::read(file).times; }

/// Own steps of 0.01 s and of 0.03 s, which never meet a multiple of 0.1 s but at 0.3 s and so on.
TEST(RowChoice, KeepsTheFirstRowAtOrAfterEachMultipleAndTheLast) {
  for (const bool own : {false, true}) {
    const Scratch folder;
    RecorderBench bench({0.01, 0.03}, 0.65);
    Recording what{folder.path()};
    what.own = own;
    what.rows.every = 0.1;
    bench.record(what);
    const auto times = times_of((folder.path() / (own ? "results.a.csv" : "results.csv")).string());
    ASSERT_EQ(times.size(), 8U);
    for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(times[k], 0.1 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(times[7], 0.65, 1e-12);
    if (!own) continue;
    const std::vector<double> slow = times_of((folder.path() / "results.b.csv").string()),
                              expected = {0.0, 0.12, 0.21, 0.3, 0.42, 0.51, 0.6, 0.63};
    ASSERT_EQ(slow.size(), expected.size());
    for (std::size_t k = 0; k < slow.size(); ++k) EXPECT_NEAR(slow[k], expected[k], 1e-12);
  }
}

TEST(RowChoice, AWindowHasTheRowsOfItsTimesWithItsOwnMultiples) {
  const Scratch folder;
  RecorderBench bench({0.01});
  Recording what{folder.path()};
  what.rows = {0.5, 1.0, 0.2};
  bench.record(what);
  const std::vector<double> expected = {0.5, 0.7, 0.9},
                            times = times_of((folder.path() / "results.csv").string());
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], expected[k], 1e-12);
}

/// The same rows as all of them, less some: no other values. However far apart, and with a long step too.
TEST(RowChoice, KeptRowsAreThoseOfAWholeRecording) {
  const Scratch folder;
  std::vector<std::string> files;
  for (const double every : {0.0, 0.05, 0.011, 0.5}) {
    RecorderBench bench({0.01, 0.007});
    Recording what{folder.path() / std::to_string(every)};
    what.rows.every = every;
    bench.record(what);
    files.push_back(read_text(what.directory / "results.csv"));
  }
  for (std::size_t k = 1; k < files.size(); ++k) {
    std::istringstream kept(files[k]);
    std::size_t at = 0, rows = 0;
    for (std::string line; std::getline(kept, line); ++rows) {
      at = files[0].find(line + "\n", at);
      ASSERT_NE(at, std::string::npos) << line;
    }
    EXPECT_EQ(rows, std::vector<std::size_t>({0, 42, 183, 6})[k]);
  }
}

TEST(RowChoice, BothRowsOfAJumpAreKeptOrNone) {
  RowChoice choice({.every = 1.0}, 0.0);
  std::vector<bool> kept;
  for (const double t : {0.0, 0.0, 0.5, 0.5, 1.2, 1.2, 1.2, 1.9, 2.0, 3.5, 3.9, 4.1})
    kept.push_back(choice.takes(t, false));
  EXPECT_EQ(kept,
            (std::vector<bool>{true, true, false, false, true, true, true, false, true, true, false, true}));
  EXPECT_TRUE(choice.takes(4.2, true));
}

}  // namespace
}  // namespace tandem
