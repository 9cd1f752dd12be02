// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The command view: what it writes and what it refuses. tests/view looks at the pages in a browser.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "tandem/error.hpp"
#include "tandem/text/time_table.hpp"
#include "view/page.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

std::string scenario_file(const std::string& name) {
  return std::string(TANDEM_SOURCE_DIR) + "/scenarios/" + name;
}

bool says(const Said& said, const std::string& words) { return said.err.find(words) != std::string::npos; }

/// The data in a page.
nlohmann::json data_in(const std::filesystem::path& page) {
  const std::string text = test::read_text(page), begin = R"(<script type="application/json" id="data">)";
  const auto from = text.find(begin) + begin.size();
  return nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
}

class ViewCommand : public testing::Test {
 protected:
  void SetUp() override {
    try {
      view::check_page();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  Said run(const std::string& scenario, std::vector<std::string> more) const {
    std::vector<std::string> all{"run", scenario_file(scenario)};
    all.insert(all.end(), more.begin(), more.end());
    return tandem(folder, all);
  }

  const Scratch folder;
};

TEST_F(ViewCommand, WritesAPageBesideTheResults) {
  ASSERT_EQ(run("mechanisms/bricard/bricard.toml", {"--set", "run.stop=0.02", "--output", "o"}).status, 0);
  const Said said = tandem(folder, {"view", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(said.out, "wrote o/view.html\n");
  const auto data = data_in(folder.path() / "o" / "view.html");
  EXPECT_EQ(data["title"], "bricard");
  const auto& result = data["results"][0];
  EXPECT_EQ(result["mechanisms"][0]["rods"].size(), 5U);
  EXPECT_EQ(result["tables"][0]["rows"], 21);
  EXPECT_EQ(data["plots"], (nlohmann::json{"bricard.x", "bricard.energy", "bricard.y", "bricard.z"}));
}

TEST_F(ViewCommand, ASceneSaysHowToRecordWhereItsPointsAre) {
  const std::string scene = "split_pendulum/split_pendulum.toml";
  ASSERT_EQ(run(scene, {"--set", "span.stop=0.01", "--output", "o"}).status, 0);
  const Said without = tandem(folder, {"view", "o"});
  EXPECT_EQ(without.status, 2);
  EXPECT_TRUE(says(without, "no column upper.A.x")) << without.err;
  EXPECT_TRUE(says(without, "--set record.animate=true")) << without.err;
  EXPECT_EQ(tandem(folder, {"view", "o", "--plots-only"}).status, 0);
  ASSERT_EQ(run(scene, {"--set", "span.stop=0.01", "--set", "record.animate=true", "--set",
                        "record.ports=['upper.x']", "--output", "p"})
                .status,
            0);
  const auto names = text::TimeTable::read(folder.path() / "p").names;
  for (const char* name : {"upper.x", "upper.A.y", "lower.B.x"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_EQ(std::find(names.begin(), names.end(), "upper.y"), names.end());
  const Said with = tandem(folder, {"view", "p", "--with", "o/results.csv"});
  EXPECT_EQ(with.status, 0) << with.err;
}

TEST_F(ViewCommand, OfMoreRowsThanAPageCanShowItHasBandsAndSaysSo) {
  constexpr int rows = 500'000;
  std::string text = "time,x\n";
  for (int k = 0; k < rows; ++k)
    text += std::to_string(k) + (k == 4321 ? ",9\n" : k % 2 == 0 ? ",1\n" : ",0\n");
  folder.write("long.csv", text);
  const Said said = tandem(folder, {"view", "long.csv"});
  const std::string note =
      "long.csv has 500000 rows, too many for a page: of each 6 the smallest and the largest value";
  EXPECT_TRUE(says(said, "note: " + note)) << said.err;
  const auto data = data_in(folder.path() / "long.html");
  EXPECT_TRUE(test::contains(data["notes"].back(), note));
  const auto& table = data["results"][0]["tables"][0];
  EXPECT_LE(table["rows"], 200'000);
  EXPECT_EQ(table["left_out"].get<int>() + table["rows"].get<int>(), rows);
  ASSERT_EQ(tandem(folder, {"view", "long.csv", "--every", "1"}).status, 0);
  const auto all = data_in(folder.path() / "long.html");
  EXPECT_EQ(all["results"][0]["tables"][0]["rows"], rows);
}

TEST_F(ViewCommand, RefusesWhatItCanNotShow) {
  EXPECT_TRUE(says(tandem(folder, {"view", "nowhere"}), "'nowhere' is not there"));
  EXPECT_TRUE(says(tandem(folder, {"view", "."}), "results.json' is missing; 'tandem run' writes it"));
  folder.write("results.json", "{}");
  EXPECT_TRUE(says(tandem(folder, {"view", "."}), "is not one of a run"));
  EXPECT_EQ(tandem(folder, {"view", ".", "--every", "0"}).status, 2);
}

TEST_F(ViewCommand, AMechanismThatIsGoneIsNamed) {
  folder.write("m.toml",
               "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
               "[run]\nstop = 0.1\nstep = 0.01\n");
  ASSERT_EQ(tandem(folder, {"run", "m.toml", "--output", "o"}).status, 0);
  std::filesystem::remove(folder.path() / "m.toml");
  const Said said = tandem(folder, {"view", "o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(says(said, "file 'm.toml' of the mechanism 'm'")) << said.err;
}

TEST_F(ViewCommand, ARunChecksWhatTheViewIsToldByItsFiles) {
  const std::string mass =
      "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
      "[run]\nstop = 0.1\nstep = 0.01\n";
  folder.write("m.toml", mass + "[view]\nfollow = 'Q'\n");
  for (const char* command : {"run", "info"}) {
    const Said said = tandem(folder, {command, "m.toml"});
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(says(said, "m.toml:10: view.follow: point 'Q' is not there")) << said.err;
  }
  const Said none =
      tandem(folder, {"run", scenario_file("two_mass/two_mass.toml"), "--set", "record.animate=true"});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(
      says(none, "record.animate is true, but no subsystem has a source that tells where its points are"))
      << none.err;
  const Said plots =
      tandem(folder, {"run", scenario_file("two_mass/two_mass.toml"), "--set", "view.plots=['fast.x9']"});
  EXPECT_EQ(plots.status, 2);
  EXPECT_TRUE(says(plots, "view.plots: output 'fast.x9' is not there")) << plots.err;
}

TEST_F(ViewCommand, BeginsWithThePlotsThatAreAskedFor) {
  ASSERT_EQ(run("two_mass/two_mass.toml", {"--no-reference", "--set", "span.stop=1", "--set",
                                           "view.plots=['slow.x2']", "--output", "o"})
                .status,
            0);
  ASSERT_EQ(tandem(folder, {"view", "o", "--output", "page.html"}).status, 0);
  const auto data = data_in(folder.path() / "page.html");
  const nlohmann::json plots{"slow.x2", "defect(slow.x1)", "defect(fast.x2)", "energy(slow.x2:fast.x1)"};
  EXPECT_EQ(data["plots"], plots) << "and what the run's indicators are, under them";
  EXPECT_EQ(data["notes"][0], "No subsystem of this run is a mechanism from a file: there are plots only.");
}

TEST_F(ViewCommand, KeepsOneOfSoManyRowsIfToldAndTheLast) {
  ASSERT_EQ(run("mechanisms/pendulum/pendulum.toml", {"--set", "run.stop=0.025", "--output", "o"}).status, 0);
  ASSERT_EQ(tandem(folder, {"view", "o", "--every", "10"}).status, 0);
  const auto data = data_in(folder.path() / "o" / "view.html");
  EXPECT_EQ(data["results"][0]["tables"][0]["rows"], 4);
  EXPECT_EQ(data["results"][0]["tables"][0]["left_out"], 22);
  EXPECT_EQ(data["notes"][0], "One of each 10 rows of results.csv is shown, 4 of 26.");
}

}  // namespace
}  // namespace tandem
