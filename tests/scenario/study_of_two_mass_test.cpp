// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// scenarios/two_mass/study.toml gives what the sweep in C++ gives.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"
#include "two_mass/experiment.hpp"

namespace tandem::two_mass_study_tests {
namespace {

using test::read_text;

/// Cells by the name of their column, row by row.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& table) {
  std::istringstream lines(table);
  std::string line, name, cell;
  std::getline(lines, line);
  const std::string header = line;
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(lines, line)) {
    std::istringstream names(header), cells(line);
    rows.emplace_back();
    while (std::getline(names, name, ',')) rows.back()[name] = std::getline(cells, cell, ',') ? cell : "";
  }
  return rows;
}

/// tolerance: relative.
void is(const std::string& cell, const std::optional<double>& expected, double tolerance) {
  ASSERT_EQ(cell.empty(), !expected.has_value());
  if (expected) {
    EXPECT_NEAR(std::stod(cell), *expected, tolerance * std::abs(*expected));
  }
}

TEST(StudyOfTwoMass, GivesTheRowsOfItsSweep) {
  std::string text = read_text(test::two_mass_file("study.toml"));
  const auto begin = text.find("ratios = ["), end = text.find(']', begin);
  text.replace(begin, end - begin, "ratios = [3.7, 30, 57.3, 150");
  for (const char* file : {"two_mass.toml", "exact.toml"})
    text.replace(text.find("\"" + std::string(file)) + 1, std::string(file).size(),
                 test::two_mass_file(file));
  const test::Scratch folder;
  folder.write("s.toml", text);
  const test::Said said = test::tandem(folder, {"sweep", "s.toml", "--table", "sweep", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto rows = rows_of(read_text(folder.path() / "o/sweep.csv"));
  const auto schemes = two_mass::sweep_schemes(false);
  ASSERT_EQ(rows.size(), 4 * schemes.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto row = rows[k];
    const two_mass::Scheme& scheme = schemes[k % schemes.size()];
    SCOPED_TRACE(
        fmt::format("{} {} {} {}", scheme.schedule, scheme.to_fast, scheme.to_slow, row["frequency_ratio"]));
    EXPECT_EQ(row["schedule"] + row["to_fast"] + row["to_slow"],
              scheme.schedule + scheme.to_fast + scheme.to_slow);
    const auto expected = two_mass::run_case({scheme, std::stod(row["frequency_ratio"])});
    const two_mass::Figures& f = expected.figures;
    // The study ends a run by its speed too, and so some in which displacements alone are not large enough
    // yet.
    if (row["status"] == "lost") {
      EXPECT_TRUE(f.failed || *f.energy_error > 1e10);
      continue;
    }
    EXPECT_EQ(row["status"], f.failed ? "lost" : "ok");
    // Staggered, the fast side has nodes that are not those of the exact motion, at whose times the study
    // compares.
    const double other_nodes = scheme.schedule == "staggered" ? 1e-3 : 1e-14;
    is(row["position_error"], f.position_error, other_nodes);
    is(row["position_error_exact"], f.position_error_exact, other_nodes);
    is(row["energy_error"], f.energy_error,
       1e-11);  // sums in another order: its terms cancel to 1e-5 of them
    is(row["exchange_energy_error"], f.exchange_energy_error, 0.0);
    is(row["amplitude_error"], f.amplitude_error, 0.0);
    is(row["phase_error"], f.phase_error, 0.0);
    EXPECT_EQ(row["exchanges"], std::to_string(expected.exchanges));
    EXPECT_EQ(row["evaluations"], std::to_string(expected.evaluations));
  }
}

}  // namespace
}  // namespace tandem::two_mass_study_tests
