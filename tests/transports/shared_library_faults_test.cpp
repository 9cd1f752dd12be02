// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "child.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "scratch.hpp"
#include "tandem/shared_library/shared_library.hpp"

namespace tandem {
namespace {

using test::refuses;

const std::string faulty = TANDEM_FAULTY_LIBRARY;

Builtins with_libraries() {
  Builtins builtins;
  add_shared_library(builtins);
  return builtins;
}

auto opening(const std::string& uri) {
  return [uri] { open(uri, with_libraries()); };
}
std::string entry(const std::string& name) { return "lib:" + faulty + "?entry=" + name; }

TEST(SharedLibrary, OneThatIsNotThereOrNoLibraryIsRefusedByName) {
  const test::Scratch scratch;
  const std::string text = scratch.write("text.so", "no library").string();
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"'/none.so'", "not there"}, opening("lib:/none.so")));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"text.so", "can't be loaded"}, opening("lib:" + text)));
}

TEST(SharedLibrary, IsLookedForInTheFolderOfTheScenario) {
  const std::filesystem::path file(faulty);
  Opening from{{}, file.parent_path()};
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {file.string(), "no symbol 'tandem_subsystem'", "entry="},
                      [&] { open("lib:" + file.filename().string(), with_libraries(), from); }));
}

TEST(SharedLibrary, ATableThatCanNotBeUsedIsRefusedWithTheNameOfTheFile) {
  const auto says = [](const std::string& name, ErrorCode code, const std::string& text) {
    return refuses(code, {faulty, text}, opening(entry(name)));
  };
  EXPECT_TRUE(says("none", ErrorCode::invalid_argument, "no symbol 'none'"));
  EXPECT_TRUE(says("no_table", ErrorCode::invalid_argument, "no table"));
  EXPECT_TRUE(says("entry_throws", ErrorCode::internal, "not today"));
  EXPECT_TRUE(says("wrong_version", ErrorCode::not_supported, "ABI version 99; allowed is 1"));
  EXPECT_TRUE(says("missing_function", ErrorCode::invalid_argument, "lacks"));
  EXPECT_TRUE(says("garbage_size", ErrorCode::invalid_argument, "2000000000 scalars"));
  EXPECT_TRUE(says("garbage_count", ErrorCode::invalid_argument, "-7 ports"));
}

TEST(SharedLibrary, WhatBreaksTheContractInARunEndsItWithASentence) {
  const auto run = [](const std::string& name) {
    return [name] {
      const auto subsystem = open(entry(name), with_libraries());
      test::RunBench().add("it", *subsystem).run(1.0);
    };
  };
  EXPECT_TRUE(refuses(ErrorCode::internal, {"'it'", "advance", "no oil"}, run("throws")));
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"'it'", "x", "not finite", "t = 0.1 s"}, run("not_a_number")));
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"'it'", "t = 5 s", "past its limit"}, run("past_the_limit")));
}

TEST(SharedLibrary, OneThatAbortsIsTriedInAProcessOfItsOwn) {
  test::Child check({"sh", "-c", "exec '" TANDEM_COMMAND "' check '" + entry("aborts") + "' 2>&1"});
  EXPECT_EQ(check.word_after("signal "), std::to_string(SIGABRT));
  EXPECT_EQ(check.status(), 1);
}

}  // namespace
}  // namespace tandem
