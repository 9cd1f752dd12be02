// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_kept.hpp"

#include <algorithm>

#include "has.hpp"
#include "read_metrics.hpp"
#include "tandem/nearest.hpp"

namespace tandem::study {
namespace {

using text::Section;

template <class All>
std::vector<std::string> names_of(const All& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.push_back(one.name);
  return names;
}

void check(Section& section, const char* key, const char* what, const std::string& name,
           const std::vector<std::string>& known) {
  if (!has(known, name)) refuse(section.place(key), section.name(key) + ": " + unknown(what, name, known));
}

std::string table_of(Section& section, const Study& study) {
  std::vector<std::string> known;
  for (const Table& table : study.tables)
    if (!table.search) known.push_back(table.name);
  const auto table = section.text("table");
  if (known.empty())
    refuse(section.place(), section.path() + " has no table; allowed is one that is no search");
  if (!table && known.size() > 1) section.missing("table", "one of the tables " + listed(known));
  if (table) check(section, "table", "table", *table, known);
  return table.value_or(known[0]);
}

std::string reference_of(Section& section, const Study& study) {
  const auto known = names_of(study.references);
  const auto against = section.text("against");
  if (against == "none") return "";
  if (!against && known.size() > 1)
    section.missing("against", "one of the references " + listed(known) + ", or none");
  if (against) check(section, "against", "reference", *against, known);
  return against ? *against : known.empty() ? "" : known[0];
}

void read_choice(Section& section, const Study& study, Kept& to) {
  const Table& table = *std::find_if(study.tables.begin(), study.tables.end(),
                                     [&](const Table& t) { return t.name == to.table; });
  if (const auto where = section.text("where")) {
    to.where = Formula{*where, section.place("where")};
    check_formula(*to.where, section.name("where"), study);
  }
  to.least = section.text("least").value_or(""), to.most = section.text("most").value_or("");
  if (!to.least.empty())
    section.leave_out("most", "it has `least`"), check(section, "least", "metric", to.least, table.metrics);
  if (!to.most.empty()) check(section, "most", "metric", to.most, table.metrics);
  to.per = section.texts("per");
  if (to.least.empty() && to.most.empty()) section.leave_out("per", "it has neither `least` nor `most`");
  for (const std::string& column : to.per) check(section, "per", "column", column, table.columns);
}

Kept read(Section& section, const Study& study) {
  Kept one{.name = section.required_text("name"),
           .table = table_of(section, study),
           .outputs = section.texts("outputs")};
  one.place = section.place();
  if (one.outputs.empty()) section.missing("outputs");
  read_choice(section, study, one);
  one.metrics = section.texts("metrics");
  std::vector<std::string> drifts;
  for (const Metric& metric : study.metrics)
    if (metric.is_over_time()) drifts.push_back(metric.name);
  for (const std::string& drift : one.metrics)
    check(section, "metrics", "metric with a signal or a drift", drift, drifts);
  one.against = reference_of(section, study);
  one.every = section.positive("every").value_or(0.0);
  section.refuse_unknown();
  return one;
}

}  // namespace

void read_kept(Section& root, Study& to) {
  for (Section& section : root.sections("keep")) to.kept.push_back(read(section, to));
}

}  // namespace tandem::study
