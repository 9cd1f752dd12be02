// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Studies that judge estimates and indicators.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::test::indicator_study {
namespace {

/// Numbers of a column; infinity where the cell says inf.
std::vector<double> column(const charts::CsvTable& table, const std::string& name) {
  std::vector<double> all;
  for (std::size_t k = 0; k < table.size(); ++k) all.push_back(table[k].number(name));
  return all;
}

/// Places in the order of their size; equal ones share the mean.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> places(values.size());
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    for (std::size_t k = first; k < last; ++k) places[order[k]] = 0.5 * static_cast<double>(first + last - 1);
  }
  return places;
}

/// Spearman's: that of the ranks.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto x = ranks(a), y = ranks(b);
  const double mean = 0.5 * static_cast<double>(a.size() - 1);
  double xy = 0.0, xx = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    xy += (x[k] - mean) * (y[k] - mean), xx += (x[k] - mean) * (x[k] - mean),
        yy += (y[k] - mean) * (y[k] - mean);
  return xy / std::sqrt(xx * yy);
}

/// The requirements are those of the issue of indicators, on nine of the study's 42 ratios.
TEST(IndicatorStudy, AnEstimateRanksTheSchemesOfTheTwoMassTest) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"sweep", two_mass_file("indicators.toml"), "--output", "o", "--where",
                      "frequency_ratio == 1.5 || frequency_ratio == 3.7 || frequency_ratio == 10 || "
                      "frequency_ratio == 22.5 || "
                      "frequency_ratio == 30.7 || frequency_ratio == 42.7 || frequency_ratio == 57.3 || "
                      "frequency_ratio == 77.7 || frequency_ratio == 99.5"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table = charts::CsvTable::read(folder.path() / "o/indicators.csv", {"true_error"});
  ASSERT_EQ(table.size(), 9U * 72U);
  const auto truth = column(table, "true_error"), estimate = column(table, "estimate"),
             flagged = column(table, "flagged");
  EXPECT_GE(rank_correlation(truth, estimate), 0.999) << "wanted: 0.98";
  EXPECT_LT(rank_correlation(truth, column(table, "energy_residual")), 0.8) << "it is no estimate";
  double wrong = 0.0, flagged_wrong = 0.0, flagged_right = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    wrong += truth[k] > 0.1;
    (truth[k] > 0.1 ? flagged_wrong : flagged_right) += flagged[k];
  }
  EXPECT_GE(flagged_wrong, 0.99 * wrong) << "wanted: 0.97";
  EXPECT_LE(flagged_right, 0.01 * (static_cast<double>(truth.size()) - wrong)) << "wanted: 0.03";
  EXPECT_GT(std::count(truth.begin(), truth.end(), std::numeric_limits<double>::infinity()), 0)
      << "of lost runs";
}

/// Two oscillators by chance: the fast one has 1 Hz, the slow one 1.5 to 100 times less.
std::string random_oscillators(int count) {
  std::mt19937 random(7);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  std::map<std::string, std::string> columns;
  for (int s = 0; s < count; ++s) {
    const double w = 2.0 * std::numbers::pi, ratio = std::exp(between(std::log(1.5), std::log(100.0)));
    const double c = between(0.05, 0.5) * w * w, c2 = c * std::exp(between(std::log(0.1), std::log(10.0))),
                 m2 = (c + c2) * ratio * ratio / (w * w);
    const std::pair<const char*, double> values[] = {{"s", s},
                                                     {"c1", w * w - c},
                                                     {"c2", c2},
                                                     {"c", c},
                                                     {"m2", m2},
                                                     {"d1", between(0.0, 0.04) * w},
                                                     {"d2", between(0.0, 0.04) * m2 * w / ratio},
                                                     {"d", between(0.0, 0.004) * w},
                                                     {"x2", between(-3.0, 3.0)},
                                                     {"h1", 0.01},
                                                     {"h2", 0.01 * ratio}};
    for (const auto& [name, value] : values) columns[name] += fmt::format("{}{}", s > 0 ? ", " : "", value);
  }
  std::string text = "[lists.systems]\n";
  for (const auto& [name, list] : columns) text += name + " = [" + list + "]\n";
  return text;
}

/// The estimate against the exact motion of systems that no constant was chosen for.
TEST(IndicatorStudy, AnEstimateRanksTheSchemesOfRandomOscillators) {
  const Scratch folder;
  const std::string scenes = TANDEM_SOURCE_DIR "/scenarios/oscillator/";
  std::string set, per = "'s'";
  for (const std::string name : {"m2", "c1", "c2", "d1", "d2", "c", "d", "x2"})
    set += "'constants." + name + "' = '$" + name + "'\n", per += ", '" + name + "'";
  const std::string end = "'span.stop' = 30\n";
  const std::string measured = "of = 'side1.x'\nnorm = 'rms'\nrelative = 'rms'\n";
  folder.write(
      "s.toml",
      "scenario = '" + scenes + "displacement_displacement.toml'\n[set]\n" + set + end +
          "'coordination.schedule' = '$schedule'\n'connections.reconstruction' = '$how'\n"
          "'subsystems.side1.parameters.step' = '$h1'\n'subsystems.side2.parameters.step' = '$h2'\n" +
          random_oscillators(25) +
          "[[tables.t.blocks]]\naxes = ['systems', { schedule = ['slowest-first', 'fastest-first', "
          "'parallel'] }, "
          "{ how = ['lagrange0', 'lagrange1', 'lagrange2', 'hermite'] }]\n"
          "[references.exact]\nscenario = '" +
          scenes + "exact.toml'\nper = [" + per + "]\noutputs = { 'side1.x' = 'exact.x1' }\n" +
          "[references.exact.set]\n" + set + end + "'constants.step' = 0.01\n" +
          "[references.models]\nmodels = true\nper = [" + per + ", 'h1', 'h2']\n" +
          "with = { schedule = 'fastest-first', how = 'hermite', h1 = '$(h1/16)', h2 = '$(h2/16)' }\n" +
          "[metrics.true_error]\nagainst = 'exact'\n" + measured +
          "[metrics.estimate]\nagainst = 'models'\n" + measured);
  const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table = charts::CsvTable::read(folder.path() / "o/t.csv", {"true_error", "estimate"});
  ASSERT_EQ(table.size(), 25U * 12U);
  EXPECT_GE(rank_correlation(column(table, "true_error"), column(table, "estimate")), 0.9999);
}

std::string sweep_of(const std::string& scenario, const std::string& rest, int status = 0) {
  const Scratch folder;
  folder.write("s.toml", "scenario = '" TANDEM_SOURCE_DIR "/scenarios/" + scenario + "'\n" + rest);
  const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
  EXPECT_EQ(said.status, status) << said.err;
  return status == 0 ? read_text(folder.path() / "o/t.csv") : said.err;
}

const std::string rows = "[set]\n'span.stop' = '$stop'\n[[tables.t.blocks]]\naxes = [{ stop = [1] }]\n";

TEST(IndicatorStudy, MetricsAreOfDefectsAndEnergies) {
  const std::string table =
      sweep_of("drive/drive.toml", rows +
                                       "[metrics]\nd = { defect = 'motor.w' }\n"
                                       "e = { energy = 'motor.torque:load.speed', scale = 1000 }\n");
  EXPECT_EQ(table.substr(0, table.find('\n')), "stop,d,e,status,note");
  EXPECT_NE(sweep_of("drive/drive.toml", rows + "[metrics]\nd = { defect = 'motor.x' }\n", 2).find("motor.w"),
            std::string::npos);
  EXPECT_NE(sweep_of("drive/drive.toml", rows + "[metrics]\ne = { energy = 'x:y' }\n", 2)
                .find("motor.torque:load.speed"),
            std::string::npos);
}

TEST(IndicatorStudy, WhatIsNotKnownIsWhatAMetricSaysOtherwise) {
  const std::string table = sweep_of(
      "two_mass/two_mass.toml",
      "[set]\n'coordination.schedule' = '$schedule'\n'connections.reconstruction' = 'lagrange4'\n"
      "'parameters.frequency_ratio' = 90\n"
      "[[tables.t.blocks]]\naxes = [{ schedule = ['slowest-first', 'parallel'] }]\n"
      "[metrics]\nx = { of = 'fast.x1', from = 99 }\ny = { of = 'fast.x1', from = 99, otherwise = inf }\n"
      "z = { formula = 'y > 1e3 ? 1 : 0' }\n");
  EXPECT_NE(table.find("parallel,,inf,1,lost"), std::string::npos) << table;
  EXPECT_EQ(table.find("slowest-first,,"), std::string::npos) << table;
}

/// A power train with events has no linear model.
TEST(IndicatorStudy, AReferenceByModelsTellsWhatHasNone) {
  const std::string said = sweep_of("kart/kart.toml",
                                    rows +
                                        "[references.m]\nmodels = true\nper = ['stop']\n[metrics]\n"
                                        "e = { of = 'kart.pitch' }\n",
                                    1);
  EXPECT_NE(said.find("there is no linear model of diagram:../engine/kart_power_train.toml: it has events"),
            std::string::npos)
      << said;
}

/// The load of the drive changes at 0.314 s, long after what its model is found from.
TEST(IndicatorStudy, AReferenceByModelsTellsWhatGoesByItsOwnClock) {
  const std::string whole =
      "[set]\n'connections[motor.w].reconstruction' = '$how'\n"
      "[[tables.t.blocks]]\naxes = [{ how = ['lagrange3'] }]\n"
      "[references.m]\nmodels = true\nper = ['how']\n[metrics]\ne = { of = 'load.speed' }\n";
  const std::string said = sweep_of("drive/drive.toml", whole, 1);
  EXPECT_NE(said.find("there is no linear model of diagram:load.toml: its model is farthest off at t = 0."),
            std::string::npos)
      << said;
}

}  // namespace
}  // namespace tandem::test::indicator_study
