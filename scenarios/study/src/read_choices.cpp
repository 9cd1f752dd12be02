// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_choices.hpp"

#include <algorithm>

#include "axes.hpp"
#include "has.hpp"
#include "tandem/nearest.hpp"

namespace tandem::study {
namespace {

using text::Section;

/// A text that is one of those that are known.
std::string one_of(Section& section, const char* key, const std::string& what,
                   const std::vector<std::string>& known) {
  auto name = section.required_text(key);
  if (!has(known, name)) refuse(section.place(key), section.name(key) + ": " + unknown(what, name, known));
  return name;
}

std::vector<std::string> names_of(const std::vector<Table>& tables) {
  std::vector<std::string> names;
  for (const Table& table : tables)
    if (!table.search) names.push_back(table.name);
  return names;
}

Choice read(const std::string& name, Section& section, const Study& study) {
  Choice one{.name = name, .by = {}, .of = {}, .least = {}, .cost = {}, .error = {}, .per = {}};
  one.place = section.place();
  const auto tables = names_of(study.tables);
  one.by = one_of(section, "by", "table", tables), one.of = one_of(section, "of", "table", tables);
  const Table &by = study.table(one.by), &of = study.table(one.of);
  one.least = one_of(section, "least", "metric", by.metrics);
  one.cost = one_of(section, "cost", "metric", by.metrics);
  one.error = one_of(section, "error", "metric", of.metrics);
  one.per = section.texts("per");
  for (const std::string& column : one.per)
    if (!has(of.columns, column))
      refuse(section.place("per"), section.name("per") + ": " + unknown("column", column, of.columns));
  if (by.rows != of.rows)
    refuse(section.place("by"), section.name("by") + ": the rows of " + one.by + " are not those of " +
                                    one.of + "; allowed are tables with the same rows in the same order");
  section.refuse_unknown();
  return one;
}

}  // namespace

void read_choices(Section& root, Study& to) {
  auto all = root.section("choices");
  if (!all) return;
  const auto tables = names_of(to.tables);
  for (auto& [name, section] : all->named_sections()) {
    if (!is_column_name(name))
      refuse(section.place(), "choice '" + name + "'; allowed are letters, digits and _, no digit first");
    if (has(tables, name))
      refuse(section.place(), "a choice and a table have the name " + name + "; allowed is one of them");
    to.choices.push_back(read(name, section, to));
  }
}

}  // namespace tandem::study
