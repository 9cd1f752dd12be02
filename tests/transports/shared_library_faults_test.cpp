// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

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

/// The system's loader ends the program by a signal where a page of the file is not there.
TEST(SharedLibrary, ThatEndsBeforeItsSegmentsDoIsRefusedAtAnyLength) {
  const test::Scratch scratch;
  const std::string whole = test::read_text(faulty);
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 97) {
    const std::string half = scratch.write("half.so", whole.substr(0, size)).string();
    for (const std::string scheme : {"lib:", "three_functions:"}) {
      const bool refused =
          refuses(ErrorCode::input_output, {"library '" + half + "'"}, opening(scheme + half + "?step=1"));
      EXPECT_TRUE(refused || size > whole.size() / 2) << scheme << " with " << size << " bytes";
      if (!refused) break;  // only what no segment holds is cut off
    }
  }
  const std::string half = scratch.write("half.so", whole.substr(0, whole.size() / 2)).string();
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"half.so' is truncated: it has ", "allowed are "},
                      opening("lib:" + half)));
}

TEST(SharedLibrary, ASymbolThatIsDataIsNotCalled) {
  for (const std::string name : {"counter", "constant", "of_a_thread", "environ"}) {
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                        {"library '" + faulty + "'", "'" + name + "' is data; allowed is a function"},
                        opening(entry(name))));
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'" + name + "' is data"},
                        opening("three_functions:" + faulty + "?step=1&initiate=" + name)));
  }
}

/// Each ends its process: it is tried through the command, in a run, a check and a served session.
class LibraryThatExits : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Entries, LibraryThatExits,
                         testing::Values("exits", "exits_quickly", "exits_at_once", "exits_in_create",
                                         "exits_in_destroy", "exits_as_entry"),
                         [](const auto& one) { return one.param; });

TEST_P(LibraryThatExits, GivesNoStatusOfSuccess) {
  const test::Scratch scratch;
  const auto scenario = scratch.write(
      "s.toml", "[subsystems.it]\nsource = \"" + entry(GetParam()) + "\"\n[span]\nstart = 0\nstop = 1\n");
  const std::string tandem = "exec '" TANDEM_COMMAND "' ", output = (scratch.path() / "o").string();
  for (const std::string& command : {tandem + "run " + scenario.string() + " --quiet --output " + output,
                                     tandem + "check '" + entry(GetParam()) + "'"}) {
    test::Child child({"sh", "-c", command + " 2>&1"});
    EXPECT_EQ(child.word_after(" ended the ").substr(0, 7), "program") << command;
    EXPECT_EQ(child.status(), 1) << command;
  }
}

/// A run of one entry that ends it while no call of this thread is under way: nobody knows which library it was.
void expect_end_besides_a_call(const std::string& how, const std::string& said, const std::string& next) {
  const test::Scratch scratch;
  const auto scenario = scratch.write(
      "s.toml", "[subsystems.it]\nsource = \"" + entry(how) + "\"\n[span]\nstart = 0\nstop = 1\n");
  test::Child child({"sh", "-c",
                     "exec '" TANDEM_COMMAND "' run " + scenario.string() + " --quiet --output " +
                         (scratch.path() / "o").string() + " 2>&1"});
  EXPECT_EQ(child.word_after("tandem: a library that was loaded" + said), next) << how;
  EXPECT_EQ(child.status(), 1) << how;
}

TEST(SharedLibrary, OneThatExitsBesidesACallGivesNoStatusOfSuccessEither) {
  expect_end_besides_a_call("exits_when_unloaded", " ended the program in the middle of the ", "work;");
}

TEST(SharedLibrary, AFaultOutsideOfACallIsASentenceToo) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer has these signals";
#endif
  expect_end_besides_a_call("faults_when_unloaded", ", or tandem itself, gave up (abort) outside of a ",
                            "call");
}

TEST(SharedLibrary, AProcessThatALibraryMakesMayEndAsItLikes) {
  const test::Scratch scratch;
  const auto scenario = scratch.write(
      "s.toml", "[subsystems.it]\nsource = \"" + entry("forks") + "\"\n[span]\nstart = 0\nstop = 1\n");
  test::Child child({"sh", "-c",
                     "'" TANDEM_COMMAND "' run " + scenario.string() + " --quiet --output " +
                         (scratch.path() / "o").string() + " 2>&1; echo status $?"});
  EXPECT_EQ(child.word_after("status "), "0");
  EXPECT_EQ(child.status(), 0);
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
  EXPECT_TRUE(says("creates_nothing", ErrorCode::invalid_argument, "create gave no instance and no error"));
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
  const std::string library = "of library '" + faulty + "'";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"'it'", library, "rewrote the row that it had given at t = 0 s"}, run("rewrites")));
  EXPECT_TRUE(refuses(ErrorCode::numerical,
                      {"'it'", "it gave 0.5 as the jump flag of its sample at t = 0.1 s; allowed is 0 or 1"},
                      run("flag_of_a_half")));
}

/// Ten calls are sound, the next is not. In a run: a sentence, status 1, every row before it, results.json.
TEST(SharedLibrary, AFaultInACallEndsTheRunWithASentenceAndItsRows) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer has these signals";
#endif
  const std::string nowhere = "it reached for memory that is not there (signal 11)";
  for (const auto& [how, what, rows] :
       {std::tuple{"aborts", std::string("it gave up (abort) (signal 6)"), 1},
        {"reaches_for_nothing", nowhere, 11},
        {"calls_itself", nowhere, 11},
        {"faults_beside", "a thread beside the calls gave up (abort) (s", 11},
        {"exits_beside", "a thread beside the calls ended the program", 11},
        {"faults_in_a_thread", "a thread beside the calls gave up (abort)", 1},
        {"exits_in_a_thread", "a thread beside the calls ended the program", 1},
        {"exits", "it ended the program; allowed is to return; it", 1}}) {
    const test::Scratch scratch;
    const auto scenario = scratch.write(
        "s.toml", "[subsystems.it]\nsource = \"" + entry(how) + "\"\n[span]\nstart = 0\nstop = 5\n");
    const std::string output = (scratch.path() / "o").string();
    test::Child run({"sh", "-c",
                     "exec '" TANDEM_COMMAND "' run " + scenario.string() + " --quiet --output " + output +
                         " > " + output + ".txt 2>&1"});
    EXPECT_EQ(run.status(), 1) << how;
    const std::string said = test::read_text(output + ".txt"),
                      table = test::read_text(output + "/results.csv"),
                      about = test::read_text(output + "/results.json");
    EXPECT_NE(said.find(", advance: " + what), std::string::npos) << said;
    EXPECT_NE(said.find("called again"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), rows + 1) << how << table;
    EXPECT_NE(about.find("\"failed\""), std::string::npos) << about;
    EXPECT_NE(about.find(what), std::string::npos) << about;
  }
}

/// The results stay where they were begun.
TEST(SharedLibrary, OneThatGoesElsewhereTakesNothingAlong) {
  const test::Scratch scratch;
  scratch.write("s.toml",
                "[subsystems.it]\nsource = \"" + entry("goes_elsewhere") + "\"\n[span]\nstop = 5\n");
  test::Child run({"sh", "-c",
                   "cd '" + scratch.path().string() +
                       "' && exec '" TANDEM_COMMAND "' run s.toml --quiet --output o > out.txt 2>&1"});
  EXPECT_EQ(run.status(), 0) << test::read_text(scratch.path() / "out.txt");
  EXPECT_NE(test::read_text(scratch.path() / "o/results.json").find("\"ok\""), std::string::npos);
}

/// Behind a program that the run has started it is the run that tells it.
TEST(SharedLibrary, AFaultInAServerIsASentenceOfItsRun) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer has these signals";
#endif
  const test::Scratch scratch;
  const auto scenario = scratch.write(
      "s.toml", std::string("[subsystems.it]\ncommand = [\"" TANDEM_COMMAND "\", \"serve\", \"") +
                    entry("reaches_for_nothing") + "\"]\n[span]\nstart = 0\nstop = 5\n");
  const std::string output = (scratch.path() / "o").string();
  test::Child run(
      {"sh", "-c",
       "exec '" TANDEM_COMMAND "' run " + scenario.string() + " --quiet --output " + output + " 2>&1"});
  EXPECT_EQ(run.word_after("it reached for memory that is not there (signal "), "11);");
  EXPECT_EQ(run.status(), 1);
}

/// A run of one entry in a process of its own: what it said, and its results.
struct IsolatedRun {
  int status;
  std::string said, table;
};
IsolatedRun isolated(const std::string& how, const std::string& more) {
  const test::Scratch scratch;
  const auto scenario = scratch.write("s.toml", "[subsystems.it]\nsource = \"lib:" + faulty + "\"\n" + more +
                                                    "parameters = { entry = \"" + how +
                                                    "\", deadline = 5 }\n[span]\nstop = 5\n");
  const std::string output = (scratch.path() / "o").string();
  test::Child run({"sh", "-c",
                   "exec '" TANDEM_COMMAND "' run " + scenario.string() + " --quiet --output " + output +
                       " > " + output + ".txt 2>&1"});
  const int status = run.status();
  return {status, test::read_text(output + ".txt"), test::read_text(output + "/results.csv")};
}

TEST(SharedLibrary, IsolatedItIsTheSameAndEndsItsProcessAlone) {
  const IsolatedRun plain = isolated("without_a_fault", ""),
                    own = isolated("without_a_fault", "isolate = true\n");
  EXPECT_EQ(plain.status, 0) << plain.said;
  EXPECT_EQ(own.status, 0) << own.said;
  EXPECT_EQ(std::count(own.table.begin(), own.table.end(), '\n'), 52);
  EXPECT_EQ(own.table, plain.table);
  for (const auto& [how, what] :
       {std::pair{"reaches_for_nothing", "it reached for memory that is not there (signal 11)"},
        {"exits", "was ended by a library in the middle of the work; allowed is to return"},
        {"exits_in_a_thread", "was ended by a library in the middle of the work"},
        {"faults_in_a_thread", "a thread beside the calls gave up (abort)"},
        {"computes_on", "5 s"}}) {
    const IsolatedRun run = isolated(how, "isolate = true\n");
    EXPECT_EQ(run.status, 1) << how;
    EXPECT_NE(run.said.find("subsystem 'it'"), std::string::npos) << run.said;
    EXPECT_NE(run.said.find(what), std::string::npos) << run.said;
    EXPECT_EQ(run.said.find("tandem: "), run.said.rfind("tandem: ")) << run.said;
    EXPECT_GE(std::count(run.table.begin(), run.table.end(), '\n'), 2) << how;
  }
}

/// Before the first row, too, a library that ends its process is no bad input.
TEST(SharedLibrary, IsolatedItsEndInCreateIsAFailure) {
  for (const char* how : {"exits_in_create", "exits_as_entry"}) {
    const IsolatedRun run = isolated(how, "isolate = true\n");
    EXPECT_EQ(run.status, 1) << how << run.said;
    EXPECT_NE(run.said.find("was ended by a library in the middle of the work"), std::string::npos)
        << run.said;
  }
}

/// After all rows: they stand, and the status tells.
TEST(SharedLibrary, IsolatedItsBadEndIsStatusOne) {
  for (const char* how : {"exits_in_destroy", "exits_when_unloaded"}) {
    const IsolatedRun run = isolated(how, "isolate = true\n");
    EXPECT_EQ(run.status, 1) << how << run.said;
    EXPECT_EQ(std::count(run.table.begin(), run.table.end(), '\n'), 52) << how;
  }
}

TEST(SharedLibrary, OneThatAbortsIsTriedInAProcessOfItsOwn) {
  test::Child check({"sh", "-c", "exec '" TANDEM_COMMAND "' check '" + entry("aborts") + "' 2>&1"});
  EXPECT_EQ(check.word_after("signal "), std::to_string(SIGABRT));
  EXPECT_EQ(check.status(), 1);
}

}  // namespace
}  // namespace tandem
