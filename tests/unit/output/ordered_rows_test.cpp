// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/ordered_rows.hpp"

#include <gtest/gtest.h>

#include "tandem/output/parallel.hpp"
#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::output {
namespace {

TEST(OrderedRows, HasTheFirstOnesInTheFileAtOnce) {
  const test::Scratch folder;
  const auto file = folder.path() / "t.csv";
  OrderedRows rows(file, "a,b");
  rows.set(1, "1,1");
  EXPECT_EQ(rows.written(), 0U);
  EXPECT_EQ(test::read_text(file), "a,b\n");
  rows.set(0, "0,0");
  EXPECT_EQ(rows.written(), 2U);
  EXPECT_EQ(test::read_text(file), "a,b\n0,0\n1,1\n");
  rows.set(3, "3,3");
  rows.set(2, "2,2");
  rows.add("4,4");
  EXPECT_EQ(test::read_text(file), "a,b\n0,0\n1,1\n2,2\n3,3\n4,4\n");
}

TEST(OrderedRows, KeepsTheOrderOfThreads) {
  const test::Scratch folder;
  OrderedRows rows(folder.path() / "t.csv", "n");
  for_each_in_parallel(
      1000, 4, [&](std::size_t i) { rows.set(i, std::to_string(i)); }, [](std::size_t) { return true; });
  std::string expected = "n\n";
  for (int i = 0; i < 1000; ++i) expected += std::to_string(i) + "\n";
  EXPECT_EQ(test::read_text(folder.path() / "t.csv"), expected);
}

TEST(OrderedRows, RefusesAFolderThatIsNotThereAndAFullDisk) {
  const test::Scratch folder;
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"none/t.csv' can't be written", "No such file"},
                            [&] { OrderedRows(folder.path() / "none" / "t.csv", "a"); }));
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"'/dev/full' can't be written", "No space left"},
                            [] { OrderedRows("/dev/full", "a"); }));
}

}  // namespace
}  // namespace tandem::output
