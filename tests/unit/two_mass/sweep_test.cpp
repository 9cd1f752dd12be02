// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/sweep.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::two_mass {
namespace {

using test::read_text;
using test::refuses;
using test::Scratch;

std::vector<Case> few_cases(double duration = 20.0) {
  std::vector<Case> cases;
  for (const double ratio : {2.0, 30.7, 95.0})
    for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
      cases.push_back({{schedule, "lagrange3", "lagrange3"}, ratio, duration});
  return cases;
}

std::vector<std::string> keys_of(const std::vector<Case>& cases) {
  std::vector<std::string> keys;
  for (const Case& c : cases) keys.push_back(sweep_key(c));
  return keys;
}

std::string swept(const Scratch& folder, unsigned threads, output::KeyedTable rows = sweep_table()) {
  const auto cases = few_cases();
  auto timings = timing_table();
  std::size_t last = 0;
  run_sweep({cases, threads, rows, timings}, [&](std::size_t done) {
    EXPECT_GE(done, last);
    last = done;
    return true;
  });
  EXPECT_EQ(last, cases.size());
  rows.write(folder.path() / "sweep.csv", keys_of(cases));
  return read_text(folder.path() / "sweep.csv");
}

TEST(Sweep, GivesTheSameTableOnAnyNumberOfThreads) {
  const Scratch folder;
  const std::string one = swept(folder, 1);
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 10);
  for (const unsigned threads : {2U, 5U, 16U}) EXPECT_EQ(swept(folder, threads), one) << threads;
}

TEST(Sweep, KeepsTheRowsThatAreThere) {
  const Scratch folder;
  auto rows = sweep_table();
  const std::string marked = "0,0,0,0,0,7,7,0,ok,kept";
  rows.set(sweep_key(few_cases()[4]), marked);
  const std::string text = swept(folder, 2, rows);
  EXPECT_NE(text.find(sweep_key(few_cases()[4]) + "," + marked + "\n"), std::string::npos) << text;
  auto read = sweep_table();
  read.read(folder.path() / "sweep.csv");
  EXPECT_EQ(read.size(), few_cases().size());
}

TEST(Sweep, EndsWithWhatIsDoneWhenAskedTo) {
  const auto cases = few_cases(5000.0);  // long enough that it is asked before the last has begun
  auto rows = sweep_table(), timings = timing_table();
  run_sweep({cases, 2, rows, timings}, [](std::size_t) { return false; });
  EXPECT_LT(rows.size(), cases.size());
  EXPECT_EQ(rows.size(), timings.size());
}

TEST(KeyedTable, RefusesAFileThatIsNotOneOfItsOwn) {
  const Scratch folder;
  const std::string header = sweep_table().header() + "\n";
  const auto refused = [&](const std::string& text, const std::vector<std::string>& why) {
    const auto file = folder.write("sweep.csv", text);
    return refuses(ErrorCode::input_output, why, [&] { sweep_table().read(file); });
  };
  EXPECT_TRUE(refused("a,b\n", {"sweep.csv:1: the header is not schedule,"}));
  EXPECT_TRUE(refused(header + "a,b,c,3,0\n", {"sweep.csv:2: the row has 5 cells; the header has 14"}));
  EXPECT_TRUE(
      refused(header + "a,b,c,3,zzz,0,0,0,0,0,0,0,ok,\n", {"sweep.csv:2: position_error is no number"}));
  EXPECT_TRUE(
      refused(header + "a,b,c,3,0,0,0,0,0,0,0,0,okk,\n", {"sweep.csv:2: status is neither ok nor failed"}));
}

}  // namespace
}  // namespace tandem::two_mass
