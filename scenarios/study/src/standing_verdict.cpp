// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "tandem/charts/csv_table.hpp"
#include "tandem/study/standing.hpp"

namespace tandem::study {
namespace {

using Row = charts::CsvTable::Row;

std::string scheme(const Row& row) {
  return fmt::format("{}, {}, steps x {}", row.text("schedule"), row.text("reconstruction"),
                     row.text("steps"));
}

std::string told(const Row& row) {
  return fmt::format("{}: {} exchanges, {} own steps, error {:.2g} of the tolerance", scheme(row),
                     row.text("exchanges"), row.text("own_steps"), row.number("error"));
}

std::tuple<double, double, double> cost(const Row& row) {
  return {row.number("exchanges"), row.number("own_steps"), row.number("error")};
}

/// How far errors can be believed.
std::string of_reference(const charts::CsvTable& table, const Row& row) {
  if (std::ranges::find(table.names(), "reference_error") == table.names().end())
    return "How far the reference itself is off is not known, as no parameter makes an own step shorter.\n";
  const double error = row.number("reference_error");
  return fmt::format("The reference itself is off by {:.2g} of the tolerance{}.\n", error,
                     error > 0.1 ? ", so smaller errors than that say nothing" : "");
}

}  // namespace

std::string standing_verdict(const std::filesystem::path& folder) {
  const auto table =
      charts::CsvTable::read(folder / "schemes.csv", {"error", "exchanges", "own_steps", "status"});
  std::size_t within = 0, ok = 0;
  const Row* cheapest = nullptr;
  const Row* closest = nullptr;
  std::vector<Row> rows;
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table[k].text("status") == "ok" && std::isfinite(table[k].number("error"))) rows.push_back(table[k]);
  for (const Row& row : rows) {
    ++ok;
    if (!closest || row.number("error") < closest->number("error")) closest = &row;
    if (row.number("error") > 1.0) continue;
    ++within;
    if (!cheapest || cost(row) < cost(*cheapest)) cheapest = &row;
  }
  std::string text = fmt::format("{} of {} rows that ran are within the tolerance.\n", within, ok);
  if (cheapest)
    text += "Cheapest of these is " + told(*cheapest) + ".\n";
  else if (closest)
    text += "The smallest error is that of " + told(*closest) + ".\n";
  return rows.empty() ? text : text + of_reference(table, rows.front());
}

}  // namespace tandem::study
