// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/program.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

using test::refuses;

TEST(Program, RunsInItsFolderAndTakesItsArgumentsAsTheyAre) {
  const test::Scratch scratch;
  const auto folder = scratch.path() / "it's a \"folder\" $(touch x)";
  std::filesystem::create_directory(folder);
  run_program({"sh", "-c", "printf '%s' \"$1\" > made", "sh", "a 'b' $HOME;`c`"}, folder, "");
  EXPECT_EQ(test::read_text(folder / "made"), "a 'b' $HOME;`c`");
}

TEST(Program, ThatCanNotBeStartedIsNamedWithWhereItComesFrom) {
  const test::Scratch scratch;
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"'tandem-no-such-program' (package p) can't be started"},
                      [&] { run_program({"tandem-no-such-program"}, scratch.path(), "package p"); }));
}

TEST(Program, ThatFailsIsQuotedWithItsLastLine) {
  const test::Scratch scratch;
  EXPECT_TRUE(refuses(ErrorCode::internal, {"program 'sh' failed: second"}, [&] {
    run_program({"sh", "-c", "echo first >&2; echo second >&2; exit 3"}, scratch.path(), "");
  }));
  EXPECT_TRUE(refuses(ErrorCode::internal, {"program 'sh' failed"}, [&] {
    run_program({"sh", "-c", "kill -9 $$"}, scratch.path(), "");
  }));
}

TEST(Program, MayWriteMoreMessagesThanAPipeHolds) {
  const test::Scratch scratch;
  run_program({"sh", "-c", "head -c 300000 /dev/zero >&2"}, scratch.path(), "");
}

TEST(Program, NeedsAFolder) {
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"/no/such/folder"},
                      [&] { run_program({"true"}, "/no/such/folder", ""); }));
}

}  // namespace
}  // namespace tandem::charts
