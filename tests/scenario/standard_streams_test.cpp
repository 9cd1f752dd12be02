// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What can't be written to a standard stream.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace tandem::test {
namespace {

/// By the shell, with the standard streams as `streams` has them.
int status_of(const std::string& arguments, const std::string& streams) {
  const int status = std::system((shell_quoted(TANDEM_COMMAND) + " " + arguments + streams).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardStreams, AnErrorOneThatIsFullLosesNoResults) {
  const Scratch folder;
  const std::string run = "run " + shell_quoted(two_mass_file("two_mass.toml")) +
                          " --no-reference --output " + shell_quoted(folder.path().string());
  EXPECT_EQ(status_of(run, " 2>/dev/full"), 0);
  EXPECT_EQ(nlohmann::json::parse(read_text(folder.path() / "results.json"))["status"], "ok");
}

TEST(StandardStreams, AnOutputOneThatIsFullIsToldWithStatusOne) {
  const Scratch folder;
  const std::string err = (folder.path() / "err.txt").string();
  for (const char* little_and_much : {"list", "help scenario"}) {
    EXPECT_EQ(status_of(little_and_much, " >/dev/full 2>" + shell_quoted(err)), 1);
    EXPECT_EQ(read_text(err), "tandem: standard output can't be written, so not all was told\n");
  }
}

/// Under a limit of its addresses or data: 200 MB are less than OpenBLAS wants for a thread of its own, which tried
/// for ever, and the command's end waited for it.
TEST(LimitedMemory, TheCommandEnds) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs more addresses";
#endif
  for (const char* limit : {"-v 200000", "-d 100000"})
    for (const char* threads : {"", "OPENBLAS_NUM_THREADS=4", "OPENBLAS_NUM_THREADS="}) {
      const std::string line = std::string("ulimit ") + limit + "; exec env " + threads +
                               " timeout 60 '" TANDEM_COMMAND "' list > /dev/null 2>&1";
      EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 0) << line;
    }
}

}  // namespace
}  // namespace tandem::test
