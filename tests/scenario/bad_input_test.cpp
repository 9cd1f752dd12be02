// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "command.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

constexpr const char* good = R"(name = "scene"
[parameters]
frequency_ratio = 25.0
[subsystems.fast]
source = "builtin:two_mass.fast"
[subsystems.slow]
source = "builtin:two_mass.slow"
[[connections]]
from = "slow.x2"
to = "fast.x2"
reconstruction = "lagrange3"
[[connections]]
from = "fast.x1"
to = "slow.x1"
reconstruction = "lagrange2"
[coordination]
schedule = "slowest-first"
[span]
stop = 1.0
[record]
clock = "fast"
)";

/// What is put in the place of a piece of the good scenario, and what the message must hold besides the file
/// and the line of that piece.
struct Bad {
  const char* name;
  std::string piece, instead;
  std::vector<std::string> words;
  int lines_after = 0;  ///< the line that is named, counted from that of the piece
};
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

class BadScenario : public testing::TestWithParam<Bad> {};

TEST_P(BadScenario, IsRefusedWithFileLineValueAndWhatIsAllowed) {
  const Bad& bad = GetParam();
  std::string text = good;
  const auto at = text.find(bad.piece);
  ASSERT_NE(at, std::string::npos);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + bad.lines_after;
  text.replace(at, bad.piece.size(), bad.instead);
  const Scratch folder;
  folder.write("scene.toml", text);
  for (const char* command : {"run", "validate"}) {
    const Said said = tandem(folder, {command, "scene.toml"});
    EXPECT_EQ(said.status, 2) << said.err;
    EXPECT_EQ(said.err.find("tandem: scene.toml:" + std::to_string(line) + ": "), 0U) << said.err;
    for (const std::string& word : bad.words)
      EXPECT_NE(said.err.find(word), std::string::npos) << word << " not in: " << said.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
}

const std::string connection_to_fast =
    "[[connections]]\nfrom = \"slow.x2\"\nto = \"fast.x2\"\nreconstruction = \"lagrange3\"\n";

INSTANTIATE_TEST_SUITE_P(
    Of, BadScenario,
    testing::Values(
        Bad{"syntax", "frequency_ratio = 25.0", "frequency_ratio = = 25.0", {"not TOML"}},
        Bad{"key_twice", "stop = 1.0", "stop = 1.0\nstop = 2.0", {"column 8", "it is there twice"}, 1},
        Bad{"unknown_key",
            "schedule =",
            "shedule =",
            {"[coordination]", "'shedule'", "did you mean 'schedule'?", "communication_step"}},
        Bad{"unknown_table", "[record]", "[recrod]", {"'recrod'", "did you mean 'record'?"}},
        Bad{"wrong_type", "stop = 1.0", "stop = \"late\"", {"span.stop", "'late'", "a number"}},
        Bad{"wrong_type_of_table", "[record]\n", "[[record]]\n", {"record is an array", "a table"}},
        Bad{"unit", "from = \"slow.x2\"", "from = \"slow.v2\"", {"'m/s'", "'m'"}, -1},
        Bad{"output", "from = \"slow.x2\"", "from = \"slow.x9\"", {"'x9'", "did you mean 'x2'?", "v2"}},
        Bad{"input", "to = \"fast.x2\"", "to = \"fast.x7\"", {"'x7'", "did you mean 'x2'?"}},
        Bad{"subsystem",
            "from = \"slow.x2\"",
            "from = \"slwo.x2\"",
            {"'slwo'", "did you mean 'slow'?", "fast"}},
        Bad{"source",
            "builtin:two_mass.fast",
            "builtin:two_mas.fast",
            {"'builtin:two_mas.fast'", "did you mean", "two_mass.both"}},
        Bad{"parameter",
            "frequency_ratio =",
            "frequency_rato =",
            {"'frequency_rato'", "did you mean 'frequency_ratio'?", "k2"}},
        Bad{"parameter_value",
            "frequency_ratio = 25.0",
            "frequency_ratio = 0.5",
            {"frequency_ratio", "0.5", "above 1"}},
        Bad{"negative_step",
            "frequency_ratio = 25.0",
            "steps_per_cycle = -100",
            {"steps_per_cycle", "-100", "above 0"}},
        Bad{"negative_communication_step",
            "schedule = \"slowest-first\"",
            "communication_step = -0.5",
            {"communication_step", "-0.5", "above 0"}},
        Bad{"degree_5",
            "reconstruction = \"lagrange3\"",
            "reconstruction = \"lagrange5\"",
            {"'lagrange5'", "lagrange0, lagrange1", "matched_hold"}},
        Bad{"schedule",
            "schedule = \"slowest-first\"",
            "schedule = \"fastest\"",
            {"'fastest'", "fastest-first", "parallel"}},
        Bad{"mean_that_schedule_cannot_honour",
            "reconstruction = \"lagrange2\"",
            "reconstruction = \"mean\"",
            {"slow.x1", "mean", "slowest-first"}},
        Bad{"order",
            "schedule = \"slowest-first\"",
            "order = [\"slow\"]",
            {"coordination.order", "'fast' is missing"}},
        Bad{"order_of_none",
            "schedule = \"slowest-first\"",
            "order = []",
            {"coordination.order", "[none]", "fast, slow"}},
        Bad{"order_of_unknown",
            "schedule = \"slowest-first\"",
            "order = [\"slow\", \"fats\"]",
            {"'fats'", "did you mean 'fast'?"}},
        Bad{"start",
            "schedule = \"slowest-first\"",
            "start = \"warm\"",
            {"'warm'", "automatic, derivatives, repeat or cold"}},
        Bad{"coupling",
            "schedule = \"slowest-first\"",
            "coupling = \"impuls\"",
            {"'impuls'", "signals, impulse, impulse_plain, impulse_stiffness or impulse_taylor"}},
        Bad{"impulse_in_parallel",
            "schedule = \"slowest-first\"",
            "schedule = \"parallel\"\ncoupling = \"impulse\"\nfast_period = 1.0",
            {"parallel", "fastest-first"}},
        Bad{"impulse_without_links",
            "schedule = \"slowest-first\"",
            "coupling = \"impulse\"\nfast_period = 1.0",
            {"no [[links]]", "effort"}},
        Bad{"end_before_start", "stop = 1.0", "stop = -2.0", {"span.stop", "-2", "after span.start"}},
        Bad{"connected_twice",
            "[coordination]",
            connection_to_fast + "[coordination]",
            {"fast.x2", "twice", "add = true"}},
        Bad{"not_connected",
            "[subsystems.fast]",
            "[subsystems.other]\nsource = \"builtin:two_mass.slow\"\n[subsystems.fast]",
            {"other.x1", "no start value"}},
        Bad{"memory_and_delay",
            "reconstruction = \"lagrange2\"",
            "reconstruction = \"lagrange2\"\nmemory = true\ndelay = true",
            {"delay", "memory = true"},
            2},
        Bad{"clock", "clock = \"fast\"", "clock = \"fsat\"", {"'fsat'", "did you mean 'fast'?", "own"}},
        Bad{"recorded_port",
            "clock = \"fast\"",
            "ports = [\"fast.x9\"]",
            {"'fast.x9'", "did you mean 'fast.x1'?", "slow.v2"}},
        Bad{"an_input_twice",
            "[subsystems.fast]",
            "[subsystems.other]\nsource = \"builtin:two_mass.slow\"\ninputs = { \"x1[0]\" = 3, x1 = 2 "
            "}\n[subsystems.fast]",
            {"subsystems.other.inputs.x1 is given twice", "one value for each input"},
            2},
        Bad{"no_recorded_port", "clock = \"fast\"", "ports = []", {"record.ports is empty", "at least one"}},
        Bad{"judge",
            "[record]",
            "[judge]\nquantity = \"fast.x9\"\ntolerance = 1\n[record]",
            {"'fast.x9'"},
            1},
        Bad{"reference",
            "[record]",
            "[reference]\nfile = \"r.csv\"\ntolerance = 1\n[record]",
            {"'r.csv' is not there"},
            1},
        Bad{"tolerance",
            "[record]",
            "[reference]\nfile = \"r.csv\"\ntolerance = -1\n[record]",
            {"reference.tolerance", "-1", "above 0"},
            2}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BadInput, AFileThatIsNotThere) {
  const Scratch folder;
  for (const char* command : {"run", "validate", "info"}) {
    const Said said = tandem(folder, {command, "nowhere.toml"});
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find("'nowhere.toml' is not there"), std::string::npos) << said.err;
  }
}

TEST(BadInput, AnAlgebraicLoopIsNamed) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", test::two_mass_file("real_loop.toml")});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("slow.F -> slow.a2 -> fast.a2 -> fast.F -> slow.F"), std::string::npos) << said.err;
}

TEST(BadInput, AnOverrideIsNamedInsteadOfALine) {
  const Scratch folder;
  folder.write("scene.toml", good);
  const Said said = tandem(folder, {"run", "scene.toml", "--set", "coordination.shedule=parallel"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("scene.toml: --set coordination.shedule=parallel: "), std::string::npos)
      << said.err;
  EXPECT_NE(said.err.find("did you mean 'schedule'?"), std::string::npos) << said.err;
}

TEST(BadInput, AWrongOptionIsStatusTwo) {
  const Scratch folder;
  EXPECT_EQ(tandem(folder, {"run"}).status, 2);
  EXPECT_EQ(tandem(folder, {"run", "x.toml", "--dryrun"}).status, 2);
  EXPECT_EQ(tandem(folder, {"rum", "x.toml"}).status, 2);
}

}  // namespace
}  // namespace tandem
