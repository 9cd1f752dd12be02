// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Numbers by name in scenarios: [constants].
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {
namespace constants_of_scenarios {

const std::string rest = R"toml(
[subsystems.a]
source = "builtin:two_mass.fast"
parameters = { frequency_ratio = "$(2*ratio)", k2 = "$k" }
[subsystems.a.inputs]
x2 = "$(k/2)"
[subsystems.b]
source = "builtin:two_mass.slow"
[[connections]]
from = "a.x1"
to = "b.x1"
reconstruction = "lagrange2"
gain = "$(-k)"
[span]
stop = "$end"
)toml";

class Constants : public testing::Test {
 protected:
  Scenario read(const std::string& text, const std::vector<std::string>& settings = {}) {
    folder_.write("s.toml", text);
    return scenario::read(folder_.path() / "s.toml", settings);
  }
  testing::AssertionResult refused(const std::string& text, const std::vector<std::string>& words) {
    return test::refuses(ErrorCode::invalid_argument, words, [&] { read(text); });
  }
  test::Scratch folder_;
};

double parameter(const SubsystemEntry& entry, const std::string& name) {
  for (const Parameter& p : entry.parameters)
    if (p.name == name) return std::get<double>(p.value);
  return 0.0;
}

TEST_F(Constants, StandForNumbersAnywhere) {
  const std::string text = "[constants]\nratio = 10\nk = \"$(ratio/4)\"\nend = 3\n" + rest;
  const Scenario one = read(text);
  EXPECT_EQ(parameter(one.subsystems[0], "frequency_ratio"), 20.0);
  EXPECT_EQ(parameter(one.subsystems[0], "k2"), 2.5);
  EXPECT_EQ(one.subsystems[0].inputs[0].at(0.0), 1.25);
  EXPECT_EQ(one.connections[0].connection.gain, -2.5);
  EXPECT_EQ(one.stop, 3.0);
  EXPECT_EQ(
      read("[constants]\nk = \"$(ratio/4)\"\nratio = 10\nend = 3\n" + rest).connections[0].connection.gain,
      -2.5)
      << "in any order";
  EXPECT_EQ(read(text, {"constants.k=7"}).connections[0].connection.gain, -7.0);
  EXPECT_EQ(read(text, {"constants.ratio=8"}).connections[0].connection.gain, -2.0);
}

TEST_F(Constants, InACircleAreRefused) {
  EXPECT_TRUE(refused("[constants]\nratio = \"$k\"\nk = \"$(ratio/4)\"\nend = 3\n" + rest,
                      {"s.toml:2", "in a circle", "ratio", "k"}));
  EXPECT_TRUE(refused("[constants]\nratio = \"$(ratio + 1)\"\nk = 1\nend = 3\n" + rest,
                      {"s.toml:2", "in a circle", "ratio"}));
}

TEST_F(Constants, WrongOnesAreRefused) {
  EXPECT_TRUE(refused("[constants]\nratoi = 10\nk = 1\nend = 3\n" + rest, {"s.toml:8", "ratio", "ratoi"}));
  EXPECT_TRUE(refused("[constants]\nk = \"$ratio\"\nratio = \"$(2*k)\"\nend = 3\n" + rest,
                      {"in a circle", "k, ratio"}));
  EXPECT_TRUE(refused("[constants]\nratio = \"ten\"\nk = 1\nend = 3\n" + rest, {"constants.ratio", "'ten'"}));
  EXPECT_TRUE(
      refused("[constants]\nratio = 10\nk = \"$(1/0)\"\nend = 3\n" + rest, {"constants.k", "finite"}));
  EXPECT_TRUE(refused(rest, {"ratio"}));
}

}  // namespace constants_of_scenarios
}  // namespace tandem::scenario
