// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Values that are drawn, rows of models, and [choices] of a study, from the command line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::study_choices_tests {
namespace {

using charts::CsvTable;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string head = "scenario = '" TANDEM_SOURCE_DIR R"toml(/scenarios/two_mass/two_mass.toml'
[set]
"parameters.frequency_ratio" = "$ratio"
"coordination.schedule" = "$schedule"
"connections.reconstruction" = "$how"
"span.stop" = 20
[references.fine]
per = ["ratio"]
with = { schedule = "fastest-first", how = "hermite" }
set = { "parameters.steps_per_cycle" = 800 }
[metrics]
error = { of = "fast.x1", norm = "rms", relative = "rms" }
exchanges = {}
)toml";
const std::string axes = R"toml([
  { ratio = [4, 9.3] }, { schedule = ["slowest-first", "parallel"] }, { how = ["lagrange0", "lagrange2", "hermite"] },
]
)toml";
const std::string both = head + "[[tables.real.blocks]]\naxes = " + axes + "[tables.guess]\nmodels = true\n" +
                         "[[tables.guess.blocks]]\naxes = " + axes;
const std::string choice =
    "[choices.advice]\nby = 'guess'\nof = 'real'\nleast = 'error'\ncost = 'exchanges'\nerror = 'error'\n";

class StudyChoices : public testing::Test {
 protected:
  Said swept(const std::string& study, const std::vector<std::string>& more = {}) {
    folder_.write("s.toml", study);
    std::vector<std::string> words{"sweep", "s.toml", "--output", "o"};
    words.insert(words.end(), more.begin(), more.end());
    return tandem(folder_, words);
  }
  CsvTable table(const std::string& name) const {
    return CsvTable::read(folder_.path() / "o" / (name + ".csv"), {});
  }
  void refused(const std::string& study, const std::string& why) {
    const Said said = swept(study);
    EXPECT_EQ(said.status, 2);
    EXPECT_NE(said.err.find(why), std::string::npos) << said.err;
  }
  Scratch folder_;
};

TEST_F(StudyChoices, AdviceOfModelsIsJudgedByWhatReallyHappens) {
  const Said said = swept(both + choice + "per = ['ratio']\n");
  ASSERT_EQ(said.status, 0) << said.err;
  const CsvTable real = table("real"), advice = table("advice");
  ASSERT_EQ(advice.names(),
            (std::vector<std::string>{"ratio", "advised", "best", "advised_error", "best_error", "rank"}));
  ASSERT_EQ(advice.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    double least = 1e9, advised = 1e9, better = 0.0;
    std::string best;
    const auto of_ratio = [&](std::size_t row) { return real[row].text("ratio") == advice[k].text("ratio"); };
    const auto words = [&](std::size_t row) {
      return real[row].text("schedule") + ' ' + real[row].text("how");
    };
    for (std::size_t row = 0; row < real.size(); ++row) {
      if (!of_ratio(row)) continue;
      if (words(row) == advice[k].text("advised")) advised = real[row].number("error");
      if (real[row].number("error") < least) least = real[row].number("error"), best = words(row);
    }
    for (std::size_t row = 0; row < real.size(); ++row)
      better += of_ratio(row) && real[row].number("error") < advised;
    EXPECT_EQ(advice[k].text("best"), best);
    EXPECT_EQ(advice[k].number("best_error"), least);
    EXPECT_EQ(advice[k].number("advised_error"), advised);
    EXPECT_EQ(advice[k].number("rank"), better + 1.0);
    EXPECT_LE(advised, 1.01 * least);
  }
}

/// The study's own file, at ratios of whole, near and awkward fractions, below and beyond 100.
TEST_F(StudyChoices, AdviceForTheTwoMassTestIsTheBest) {
  const Said said = tandem(
      folder_, {"sweep", TANDEM_SOURCE_DIR "/scenarios/two_mass/advice.toml", "--output", "o", "--where",
                "frequency_ratio == 2 || frequency_ratio == 12.6 || frequency_ratio == 45 || "
                "frequency_ratio == 77.7 || frequency_ratio == 250"});
  ASSERT_EQ(said.status, 0) << said.err;
  const CsvTable advice = table("advice");
  ASSERT_EQ(advice.size(), 5U);
  for (std::size_t k = 0; k < advice.size(); ++k)
    EXPECT_LE(advice[k].number("advised_error"), 1.01 * advice[k].number("best_error"))
        << advice[k].text("frequency_ratio") << ": " << advice[k].text("advised") << ", not "
        << advice[k].text("best");
}

/// Six of the 400 systems, and of another seed.
TEST_F(StudyChoices, AdviceForChainsIsTheBest) {
  for (const std::string seed : {"0", "3"}) {
    const Said said = tandem(folder_, {"sweep", TANDEM_SOURCE_DIR "/scenarios/chains/advice.toml", "--output",
                                       "o", "--where", "system <= 6", "--seed", seed});
    ASSERT_EQ(said.status, 0) << said.err;
    const CsvTable advice = table("advice");
    ASSERT_EQ(advice.size(), 6U);
    int best = 0;
    for (std::size_t k = 0; k < advice.size(); ++k)
      best += advice[k].number("advised_error") <= 1.01 * advice[k].number("best_error");
    EXPECT_EQ(best, 6) << "wanted: 85 %";
  }
}

/// The first row is refused: it has no error, and costs nothing.
TEST_F(StudyChoices, ARowThatIsNotKnownIsTheWorst) {
  const std::string blocks =
      "axes = [{ ratio = [4] }, { how = ['lagrange0'] }, { schedule = ['staggered', 'parallel'] }]\n";
  const Said said = swept(head + "[[tables.real.blocks]]\n" + blocks + "[tables.guess]\nmodels = true\n" +
                          "[[tables.guess.blocks]]\n" + blocks + choice);
  ASSERT_EQ(said.status, 0) << said.err;
  ASSERT_EQ(table("guess")[0].text("status"), "refused");
  const CsvTable advice = table("advice");
  ASSERT_EQ(advice.size(), 1U) << "without `per` there is one choice";
  EXPECT_EQ(advice.names().front(), "advised");
  EXPECT_EQ(advice[0].text("advised"), "4 lagrange0 parallel");
  EXPECT_EQ(advice[0].text("best"), "4 lagrange0 parallel");
  EXPECT_EQ(advice[0].number("rank"), 1.0);
}

TEST_F(StudyChoices, ASubsystemWithoutAModelRefusesARowOfModels) {
  refused("scenario = '" TANDEM_SOURCE_DIR
          "/scenarios/split_pendulum/split_pendulum.toml'\n"
          "[set]\n'span.stop' = '$stop'\n[tables.t]\nmodels = true\n[[tables.t.blocks]]\naxes = [{ stop = "
          "[0.5] }]\n"
          "[metrics]\nexchanges = {}\n",
          "there is no linear model of mechanism:lower.toml");
}

TEST_F(StudyChoices, WhatIsWrongWithAChoiceIsTold) {
  const auto with = [](const std::string& key, const std::string& value) {
    std::string text = choice;
    const auto at = text.find(key + " = '") + key.size() + 4;
    return text.replace(at, text.find('\'', at) - at, value);
  };
  refused(both + with("by", "gues"), "choices.advice.by: table 'gues' is not there; did you mean 'guess'?");
  refused(both + with("of", "x"), "choices.advice.of: table 'x' is not there");
  refused(both + with("least", "x"), "choices.advice.least: metric 'x' is not there");
  refused(both + choice + "per = ['x']\n", "choices.advice.per: column 'x' is not there");
  refused(both + "[choices.real]\nby = 'guess'\n", "a choice and a table have the name real");
  refused(both + "[choices.advice]\nby = 'guess'\n", "choices.advice.of is missing");
  refused(
      head + "[[tables.real.blocks]]\naxes = " + axes +
          "[[tables.guess.blocks]]\naxes = [{ ratio = [4] }, { schedule = ['parallel'] }, { how = ['mean'] "
          "}]\n" +
          choice,
      "choices.advice.by: the rows of guess are not those of real; allowed are tables with the same rows");
}

const std::string drawing = head + R"toml([lists.drawn]
ratio = { range = { from = 2, to = 50, count = 300, spacing = "drawn_log" } }
x = { range = { from = -1, to = 3, count = 300, spacing = "drawn" } }
[[tables.a.blocks]]
axes = ["drawn", { schedule = ["parallel"] }, { how = ["lagrange0"] }]
[[tables.b.blocks]]
axes = [{ x = { range = { from = -1, to = 3, count = 300, spacing = "drawn" } } }, { schedule = ["parallel"] }, { how = ["mean"] }, { ratio = [5] }]
)toml";

std::vector<double> column(const CsvTable& table, const std::string& name) {
  std::vector<double> all;
  for (std::size_t k = 0; k < table.size(); ++k) all.push_back(table[k].number(name));
  return all;
}

TEST_F(StudyChoices, WhatIsDrawnDependsOnNameAndSeedAlone) {
  ASSERT_EQ(swept(drawing).status, 0);
  const auto a = column(table("a"), "x"), ratio = column(table("a"), "ratio");
  EXPECT_EQ(a, column(table("b"), "x")) << "the same column in another table";
  ASSERT_EQ(swept(drawing, {"--resume"}).status, 0);
  EXPECT_EQ(a, column(table("a"), "x"));
  const Said other = swept(drawing, {"--resume", "--seed", "1"});
  EXPECT_NE(other.err.find("are of another study"), std::string::npos) << other.err;
  EXPECT_NE(a, column(table("a"), "x"));
  EXPECT_EQ(std::set<double>(a.begin(), a.end()).size(), a.size()) << "no value twice";
  const auto mean = [](const std::vector<double>& all, const auto& of) {
    double sum = 0.0;
    for (const double value : all) sum += of(value);
    return sum / static_cast<double>(all.size());
  };
  EXPECT_NEAR(mean(a, [](double v) { return v; }), 1.0, 0.2) << "0.2: three standard deviations";
  EXPECT_NEAR(mean(ratio, [](double v) { return std::log(v); }), std::log(10.0), 0.17);
  const auto [least, most] = std::minmax_element(ratio.begin(), ratio.end());
  EXPECT_GE(*least, 2.0);
  EXPECT_LE(*most, 50.0);
}

}  // namespace
}  // namespace tandem::study_choices_tests
