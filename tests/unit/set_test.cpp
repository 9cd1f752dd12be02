// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/set.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"

namespace tandem::text {
namespace {

using test::refuses;

toml::table scene() {
  return toml::parse(std::string_view(R"(
[subsystems.fast]
source = "x"
[[connections]]
to = "fast.u"
gain = 1
[[connections]]
to = "slow.u"
[span]
stop = 1
[record]
ports = ["a", "b"]
)"));
}

toml::table with(const std::string& override_text) {
  toml::table table = scene();
  set(table, override_text);
  return table;
}

TEST(Set, ReplacesAValueByItsPath) {
  EXPECT_EQ(with("span.stop=2.5").at_path("span.stop").value<double>(), 2.5);
}

TEST(Set, AddsAKeyAndTheTablesOnTheWay) {
  EXPECT_EQ(with("coordination.schedule=parallel").at_path("coordination.schedule").value<std::string>(),
            "parallel");
  EXPECT_EQ(with("subsystems.fast.parameters.k=true").at_path("subsystems.fast.parameters.k").value<bool>(),
            true);
}

TEST(Set, TakesAKeyInQuotes) {
  const toml::table table = with("subsystems.fast.parameters.\"data.load\"=a.csv");
  EXPECT_EQ(table.at_path("subsystems.fast.parameters").as_table()->get("data.load")->value<std::string>(),
            "a.csv");
  EXPECT_EQ(with("a.\"b=c%d\"=7=8").at_path("a").as_table()->get("b=c%d")->value<std::string>(), "7=8");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"has a '\"' without another"},
                      [] { with("subsystems.fast.parameters.\"data.load=a.csv"); }));
}

/// A connection to one element of a port is called by it.
TEST(Set, EndsABracketAtItsOwnEnd) {
  toml::table table =
      toml::parse(std::string_view("[[connections]]\nto = 'a.u[1]'\n[[connections]]\nto = 'b.u'\n"));
  set(table, "connections[a.u[1]].gain=2");
  EXPECT_EQ(table["connections"][0]["gain"].value<double>(), 2.0);
  EXPECT_FALSE(table["connections"][1]["gain"]);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"has a '[' without ']'"},
                      [&] { set(table, "connections[a.u[1].gain=2"); }));
}

TEST(Set, ReadsTomlAndElseAText) {
  EXPECT_TRUE(with("record.ports=[\"c\"]").at_path("record.ports").as_array()->size() == 1);
  EXPECT_EQ(with("name=a \"b\" \\ c").at_path("name").value<std::string>(), "a \"b\" \\ c");
  EXPECT_EQ(with("name=").at_path("name").value<std::string>(), "");
  EXPECT_EQ(
      with("subsystems.fast.source=builtin:a?b=c").at_path("subsystems.fast.source").value<std::string>(),
      "builtin:a?b=c");
}

TEST(Set, OfSourceAndCommandTheNewOneStays) {
  const toml::table table = with("subsystems.fast.command=[\"prog\", \"a\"]");
  const toml::table& fast = *table.at_path("subsystems.fast").as_table();
  EXPECT_EQ(fast["command"].as_array()->size(), 2U);
  EXPECT_FALSE(fast.contains("source"));
}

TEST(Set, NamesAConnectionByIndexOrByItsInputOrAll) {
  EXPECT_EQ(with("connections[1].gain=3").at_path("connections[1].gain").value<int>(), 3);
  EXPECT_EQ(with("connections[slow.u].gain=3").at_path("connections[1].gain").value<int>(), 3);
  const toml::table all = with("connections.gain=3");
  EXPECT_EQ(all.at_path("connections[0].gain").value<int>(), 3);
  EXPECT_EQ(all.at_path("connections[1].gain").value<int>(), 3);
}

TEST(Set, LeavesConnectionsOfHeldOutputsWithoutAReconstruction) {
  toml::table table = scene();
  set(table, "connections[0].reconstruction=lagrange1");
  set(table, "connections.reconstruction=hermite");
  EXPECT_EQ(table.at_path("connections[0].reconstruction").value<std::string>(), "hermite");
  EXPECT_FALSE(table.at_path("connections[1].reconstruction"));
  EXPECT_TRUE(with("connections.reconstruction=hermite").at_path("connections[1].reconstruction"))
      << "none has one: it is for the run to say what is wrong";
}

TEST(Set, ReplacesAnElementOfAnArray) {
  EXPECT_EQ(with("record.ports[1]=c").at_path("record.ports[1]").value<std::string>(), "c");
}

TEST(Set, RefusesWhatIsNotThere) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words, [&] { with(text); });
  };
  EXPECT_TRUE(
      refused("subsystems.fsat.source=y", {"table of [subsystems] 'fsat' is not there; did you mean 'fast'?",
                                           "a new one is set as a whole, subsystems.fsat={..}"}));
  EXPECT_NO_THROW(with("subsystems.slow={ source = 'y' }"));
  EXPECT_TRUE(refused("connections[2].gain=1", {"[2]", "0 (fast.u), 1 (slow.u)"}));
  EXPECT_TRUE(refused("connections[slow.v].gain=1", {"[slow.v]", "[slow.u]?"}));
  EXPECT_TRUE(refused("connections[0]=1", {"'connections[0]' is a table"}));
  EXPECT_TRUE(refused("span.stop.x=1", {"'span.stop' is the number 1", "'x'"}));
  EXPECT_TRUE(refused("record.ports[2]=c", {"'record.ports'", "array of 2", "'2'"}));
  EXPECT_TRUE(refused("coordination.order[0]=fast", {"'coordination.order' is not there"}));
}

TEST(Set, RefusesWhatIsNoPath) {
  for (const char* text : {"span.stop", "=1", "span..stop=1", "span.=1", "[0]=1", "span[=1"})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'"}, [&] { with(text); })) << text;
}

}  // namespace
}  // namespace tandem::text
