// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "choices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "has.hpp"
#include "row_key.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::study {
namespace {

struct Scheme {
  std::string words;
  double least, cost, error;
};

double known(double value) { return std::isnan(value) ? std::numeric_limits<double>::infinity() : value; }

/// The cheapest of those that are as good as the best; the first of equal ones.
const Scheme& chosen(const std::vector<Scheme>& all) {
  const auto best = std::min_element(all.begin(), all.end(),
                                     [](const auto& a, const auto& b) { return a.least < b.least; });
  const double most = Choice::alike * best->least;
  const auto before = [most](const Scheme& a, const Scheme& b) {
    return a.least <= most && (b.least > most || a.cost < b.cost);
  };
  return *std::min_element(all.begin(), all.end(), before);
}

std::string line_of(const std::vector<Scheme>& all) {
  const Scheme& advised = chosen(all);
  const auto by_error = [](const Scheme& a, const Scheme& b) { return a.error < b.error; };
  const Scheme& best = *std::min_element(all.begin(), all.end(), by_error);
  const auto better =
      std::count_if(all.begin(), all.end(), [&](const Scheme& one) { return one.error < advised.error; });
  std::string line = charts::csv_cell(advised.words) + ',' + charts::csv_cell(best.words);
  for (const double value : {advised.error, best.error, static_cast<double>(better + 1)})
    line += ',' + cell_of(value);
  return line;
}

}  // namespace

std::string choices_text(const Choice& choice, const Study& study, const std::filesystem::path& folder) {
  const auto by = charts::CsvTable::read(folder / (choice.by + ".csv"), {choice.least, choice.cost});
  const auto of = charts::CsvTable::read(folder / (choice.of + ".csv"), {choice.error});
  const Table& table = study.table(choice.of);
  std::map<std::string, std::vector<Scheme>> groups;
  std::vector<std::string> order;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    std::string words;
    for (const std::string& column : table.columns)
      if (!has(choice.per, column) && table.rows[k].contains(column))
        words += (words.empty() ? "" : " ") + cell_of(table.rows[k].at(column));
    const std::string key = row_key(choice.per, table.rows[k]);
    if (!groups.contains(key)) order.push_back(key);
    groups[key].push_back({words, known(by[k].number(choice.least)), known(by[k].number(choice.cost)),
                           known(of[k].number(choice.error))});
  }
  std::string text;
  for (const std::string& column : choice.per) text += column + ',';
  text += "advised,best,advised_error,best_error,rank\n";
  for (const std::string& key : order)
    text += key + (choice.per.empty() ? "" : ",") + line_of(groups[key]) + '\n';
  return text;
}

}  // namespace tandem::study
