// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Among equal own steps who feeds through at once follows what it reads, whatever the names are.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "command.hpp"

namespace tandem::test {
namespace {

/// x = t, then a chain of gains of 2, named as they come; the last is read by nobody.
std::string chain(const Scratch& folder, const std::vector<std::string>& names) {
  folder.write(
      "ramp.toml",
      "[blocks]\none = { kind = 'constant', value = 1 }\nx = { kind = 'integrator', input = 'one' }\n"
      "[outputs]\nx = { unit = '1' }\n");
  folder.write("gain.toml",
               "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'gain', input = 'u', gain = 2 }\n"
               "[outputs]\nx = { unit = '1' }\n");
  std::string text =
      "[span]\nstop = 1\n[parameters]\nstep = 0.0625\n[subsystems.source]\nsource = \"diagram:ramp.toml\"\n";
  std::string before = "source";
  for (const std::string& name : names) {
    text += "[subsystems." + name + "]\nsource = \"diagram:gain.toml\"\n[[connections]]\nfrom = \"" + before +
            ".x\"\nto = \"" + name + ".u\"\nreconstruction = \"lagrange0\"\n";
    before = name;
  }
  return text;
}

void expect_exact(const std::vector<std::string>& names, const std::string& schedule) {
  const Scratch folder;
  folder.write("s.toml", chain(folder, names) + "[coordination]\nschedule = \"" + schedule +
                             "\"\n[record]\nports = [\"" + names.back() + ".x\"]\n");
  const Said said = tandem(folder, {"--quiet", "run", "s.toml", "--output", "r"});
  ASSERT_EQ(said.status, 0) << said.err;
  std::istringstream rows(read_text(folder.path() / "r/results.csv"));
  std::string line;
  std::getline(rows, line);
  int count = 0;
  for (; std::getline(rows, line); ++count) {
    const double t = std::stod(line), x = std::stod(line.substr(line.find(',') + 1));
    EXPECT_EQ(x, t * static_cast<double>(1 << names.size())) << schedule;
  }
  EXPECT_EQ(count, 17);
}

TEST(FeedthroughOrder, AChainOfEqualStepsIsExactInEveryOrderOfNames) {
  std::vector<std::string> names = {"a", "b", "y", "z"};
  do {
    expect_exact(names, "slowest-first");
    expect_exact(names, "fastest-first");
  } while (std::next_permutation(names.begin(), names.end()));
}

}  // namespace
}  // namespace tandem::test
