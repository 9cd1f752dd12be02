// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "told_reference.hpp"

#include <cstring>

namespace tandem::study {
namespace {

using Doubles = std::vector<double>;

Told told(const Doubles& values) {
  Told::binary_t bytes(std::vector<std::uint8_t>(values.size() * sizeof(double)));
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

Doubles doubles(const Told& told) {
  const auto& bytes = told.get_binary();
  Doubles values(bytes.size() / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

Told told(const OutputTables& tables) {
  Told all = Told::object();
  for (const auto& [output, table] : tables) {
    Told columns = Told::array();
    for (const Doubles& column : table.columns) columns.push_back(told(column));
    all[output] = {{"file", table.file.string()},
                   {"times", told(table.times)},
                   {"names", table.names},
                   {"columns", columns}};
  }
  return all;
}

OutputTables tables(const Told& told) {
  OutputTables all;
  for (const auto& [output, table] : told.items()) {
    text::TimeTable& one = all[output];
    one = {table["file"].get<std::string>(),
           doubles(table["times"]),
           table["names"].get<std::vector<std::string>>(),
           {}};
    for (const Told& column : table["columns"]) one.columns.push_back(doubles(column));
  }
  return all;
}

}  // namespace

Told told(const ReferenceRun& run) {
  return {{"failure", run.failure},
          {"tables", told(run.tables)},
          {"finer", told(run.finer)},
          {"units", run.units}};
}

void take(const Told& made, ReferenceRun& run) {
  run.failure = made["failure"];
  run.tables = tables(made["tables"]);
  run.finer = tables(made["finer"]);
  run.units = made["units"].get<std::map<std::string, std::string>>();
}

}  // namespace tandem::study
