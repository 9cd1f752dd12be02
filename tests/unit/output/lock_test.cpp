// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/lock.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/output_file.hpp"

namespace tandem::output {
namespace {

namespace fs = std::filesystem;
using test::refuses;
using test::Scratch;

void no_note(const std::string& what) { ADD_FAILURE() << what; }

TEST(FolderLock, KeepsAFolderForOneAtATimeAndNamesWhoHasIt) {
  const Scratch scratch;
  const fs::path folder = scratch.path() / "o";
  {
    const FolderLock first(folder, no_note);
    EXPECT_TRUE(first.keeps(scratch.path() / "." / "o"));
    EXPECT_FALSE(first.keeps(scratch.path()));
    std::vector<std::string> told{"folder '" + folder.string() + "' is being written by another tandem"};
#ifdef __linux__
    told.push_back("(process " + std::to_string(::getpid()) + ")");
#endif
    EXPECT_TRUE(refuses(ErrorCode::wrong_state, told, [&] { FolderLock(folder, no_note); }));
    const FolderLock beside(scratch.path() / "p", no_note);
    std::ofstream(folder / "results.csv") << "time\n";
  }
  EXPECT_NO_THROW(FolderLock(folder, no_note));
  EXPECT_TRUE(fs::exists(folder / "results.csv"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "no file of its own";
}

TEST(FolderLock, TakesTheFoldersThatItMadeWithItIfTheyStayedEmpty) {
  const Scratch scratch;
  const fs::path outer = scratch.path() / "a";
  { const FolderLock lock(outer / "b" / "c", no_note); }
  EXPECT_FALSE(fs::exists(outer));
  {
    const FolderLock lock(outer / "b" / "c", no_note);
    std::ofstream(outer / "b" / "mine") << "mine";
  }
  EXPECT_FALSE(fs::exists(outer / "b" / "c"));
  EXPECT_TRUE(fs::exists(outer / "b" / "mine"));
  { const FolderLock lock(outer / "b", no_note); }
  EXPECT_TRUE(fs::exists(outer / "b")) << "it was there before";
}

TEST(FolderLock, AFolderThatCanNotBeMadeIsToldWithTheReason) {
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"folder '/dev/null/a' can't be made: "},
                      [] { FolderLock("/dev/null/a", no_note); }));
}

TEST(LockFile, IsOfRegularFilesOnly) {
  const Scratch scratch;
  const fs::path file = scratch.write("log", "");
  OutputFile one(file, OutputFile::Begin::kept), other(file, OutputFile::Begin::kept),
      null("/dev/null", OutputFile::Begin::kept), again("/dev/null", OutputFile::Begin::kept);
  lock_file(one.descriptor(), "log file 'a'");
  EXPECT_TRUE(refuses(ErrorCode::wrong_state, {"log file 'a' is being written by another tandem"},
                      [&] { lock_file(other.descriptor(), "log file 'a'"); }));
  lock_file(null.descriptor(), "null");
  EXPECT_NO_THROW(lock_file(again.descriptor(), "null"));
}

}  // namespace
}  // namespace tandem::output
