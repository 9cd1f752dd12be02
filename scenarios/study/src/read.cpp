// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "axes.hpp"
#include "has.hpp"
#include "read_choices.hpp"
#include "read_given.hpp"
#include "read_kept.hpp"
#include "read_metrics.hpp"
#include "read_references.hpp"
#include "read_search.hpp"
#include "row_key.hpp"
#include "tandem/nearest.hpp"
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {
namespace {

using text::Document;
using text::Section;

/// A study, table by table.
class Reader {
 public:
  Reader(Section root, Study& to) : root_(std::move(root)), to_(to) {}

  /// alone: it is a file of its own.
  void read(bool alone) {
    to_.scenario = {"", root_.text("scenario").value_or(to_.file.filename().string()),
                    root_.place("scenario")};
    to_.steps = one_given(root_, "steps");
    to_.set = all_given(root_, "set");
    read_tables();
    if (alone && !root_.node("scenario") &&
        !std::all_of(to_.tables.begin(), to_.tables.end(), [](const Table& t) { return t.scenario; }))
      root_.missing("scenario", "the file of the scenario that is run");
    for (const Given& one : to_.set) check_columns(one, "set.", to_);
    for (const Table& table : to_.tables)
      for (const Given& one : table.set) check_columns(one, "tables." + table.name + ".set.", to_);
    if (to_.steps) check_columns(*to_.steps, "", to_);
    read_references(root_, to_);
    read_metrics(root_, to_);
    order_columns();
    for (Table& table : to_.tables)
      if (table.search) check_formula(table.search->holds, "search." + table.name + ".holds", to_);
    to_.lost = read_when("lost");
    to_.unstable = read_when("unstable");
    read_kept(root_, to_);
    read_choices(root_, to_);
    to_.charts = charts::read_charts(root_);
    for (const charts::Chart& chart : to_.charts.all) check_chart(chart);
    root_.refuse_unknown();
  }

 private:
  using Named = std::vector<std::pair<std::string, Section>>;

  void read_tables() {
    const Axes axes(root_, to_.seed);
    auto all = root_.section("tables");
    const bool has_tables = all && !all->table().empty();
    if (!has_tables && !root_.node("search"))
      root_.missing("tables", "a table [tables.NAME] with [[tables.NAME.blocks]], or [[search]]");
    for (auto& [name, section] : has_tables ? all->named_sections() : Named()) {
      Table table = begun(name, section);
      for (Section& block : section.sections("blocks"))
        for (FileValues& row : axes.rows(block, table.columns)) table.rows.push_back(std::move(row));
      table.scenario = one_given(section, "scenario");
      table.set = all_given(section, "set");
      table.models = *section.flag("models");
      add(std::move(table));
      sections_.emplace(name, std::move(section));
    }
    for (Section& section : root_.sections("search")) {
      Table table = begun(section.required_text("name"), section);
      table.search = read_search(section);
      table.rows = axes.rows(section, table.columns);
      add(std::move(table));
    }
  }

  Table begun(const std::string& name, const Section& section) const {
    if (!is_column_name(name))
      refuse(section.place(), "table '" + name + "'; allowed are letters, digits and _, no digit first");
    for (const Table& table : to_.tables)
      if (table.name == name)
        refuse(section.place(), "two tables have the name " + name + "; allowed is one");
    return {.name = name, .columns = {}, .metrics = {}, .header = {}, .rows = {}, .place = section.place()};
  }

  void add(Table table) {
    if (table.rows.empty())
      refuse(table.place, "table " + table.name + " has no rows; allowed is at least one");
    refuse_twice(table);
    to_.tables.push_back(std::move(table));
  }

  static void refuse_twice(const Table& table) {
    std::set<std::string> keys;
    for (const FileValues& row : table.rows)
      if (!keys.insert(row_key(table.columns, row)).second)
        refuse(table.place, "table " + table.name + " has the row " + row_text(table.columns, row) +
                                " twice; allowed is once");
  }

  /// Of a chart of one of its tables. Others may come from elsewhere.
  void check_chart(const charts::Chart& chart) const {
    for (const Table& table : to_.tables) {
      const bool only = chart.table.empty() && to_.tables.size() == 1;
      const bool series = chart.table == table.name + ".series";
      if (!only && !series && chart.table != table.name) continue;
      const auto known = series ? to_.columns_of_series(table) : to_.columns_of(table);
      for (const charts::Quantity& one : charts::columns_of(chart))
        if (!has(known, one.text))
          refuse(one.place, "charts." + chart.name + ": " + unknown("column", one.text, known));
    }
  }

  /// Those named first, then the others.
  void order_columns() {
    const auto first = root_.texts("columns");
    check_names(root_, first);
    for (Table& table : to_.tables)
      if (table.search)
        order_search(first, table);
      else
        order_table(first, table);
  }

  /// Its column stands after its axes'.
  void order_search(const std::vector<std::string>& first, Table& table) {
    table.metrics = without_times();
    Table all = table;
    all.columns.push_back(table.search->column);
    table.header = header(first, all);
  }

  void order_table(const std::vector<std::string>& first, Table& table) {
    Section& section = sections_.at(table.name);
    const auto own = section.texts("columns");
    const auto chosen = section.texts("metrics");
    check_names(section, own);
    const auto metrics = metric_names();
    for (const std::string& name : chosen)
      if (!has(metrics, name))
        refuse(section.place("metrics"), section.name("metrics") + ": " + unknown("metric", name, metrics));
    table.metrics = section.node("metrics") ? chosen : to_.tables.size() == 1 ? metrics : without_times();
    table.header = header(own.empty() ? first : own, table);
    section.refuse_unknown();
  }

  std::vector<std::string> metric_names() const {
    std::vector<std::string> names;
    for (const Metric& metric : to_.metrics) names.push_back(metric.name);
    return names;
  }

  /// Of the key `columns`.
  void check_names(Section& section, const std::vector<std::string>& names) const {
    auto known = metric_names();
    const auto columns = to_.columns();
    known.insert(known.end(), columns.begin(), columns.end());
    for (const std::string& name : names)
      if (!has(known, name))
        refuse(section.place("columns"),
               section.name("columns") + ": " + unknown("column or metric", name, known));
  }

  std::vector<std::string> without_times() const {
    std::vector<std::string> names;
    for (const Metric& metric : to_.metrics)
      if (!metric.is_time()) names.push_back(metric.name);
    return names;
  }

  static std::vector<std::string> header(const std::vector<std::string>& first, const Table& table) {
    std::vector<std::string> all;
    for (const std::string& name : first)
      if ((has(table.columns, name) || has(table.metrics, name)) && !has(all, name)) all.push_back(name);
    for (const auto* names : {&table.columns, &table.metrics})
      for (const std::string& name : *names)
        if (!has(all, name)) all.push_back(name);
    return all;
  }

  std::optional<Formula> read_when(const char* key) {
    auto section = root_.section(key);
    if (!section) return {};
    Formula when{section->required_text("when"), section->place("when")};
    section->refuse_unknown();
    check_formula(when, section->name("when"), to_);
    return when;
  }

  Section root_;
  Study& to_;
  std::map<std::string, Section> sections_;  ///< of tables
};

Study read_document(const std::filesystem::path& file, const Document& document, std::uint64_t seed) {
  Study study;
  study.file = file, study.seed = seed;
  if (const auto* inner = document.table().get_as<toml::table>("study"))
    Reader(Section(document, keys(), *inner, "study", ""), study).read(false);
  else
    Reader(Section(document, keys()), study).read(true);
  return study;
}

}  // namespace

Study read(const std::filesystem::path& file, std::uint64_t seed) {
  return read_document(file, Document(file), seed);
}

Study read(const std::filesystem::path& file, const std::string& text) {
  return read_document(file, Document(file.string(), text), 0);
}

}  // namespace tandem::study
