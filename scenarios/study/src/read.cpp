// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "axes.hpp"
#include "read_kept.hpp"
#include "read_metrics.hpp"
#include "read_search.hpp"
#include "row_key.hpp"
#include "tandem/nearest.hpp"
#include "tandem/study/study.hpp"
#include "tandem/text/section.hpp"

namespace tandem::study {
namespace {

using text::Document;
using text::Section;

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Given given(const Document& document, const std::string& name, const toml::node& node,
            const std::string& path) {
  Given one{name, {}, document.place(node)};
  if (const auto* word = node.as_string())
    one.value = word->get();
  else if (const auto* flag = node.as_boolean())
    one.value = flag->get();
  else
    one.value = text::number_of(document, node, path);
  return one;
}

/// A study, table by table.
class Reader {
 public:
  Reader(const Document& document, Section root, Study& to)
      : document_(document), root_(std::move(root)), to_(to) {}

  /// alone: it is a file of its own.
  void read(bool alone) {
    if (alone && !root_.node("scenario")) root_.missing("scenario", "the file of the scenario that is run");
    to_.scenario = {"", root_.text("scenario").value_or(to_.file.filename().string()),
                    root_.place("scenario")};
    if (const toml::node* steps = root_.node("steps")) to_.steps = given(document_, "steps", *steps, "steps");
    to_.set = all_given(root_, "set");
    read_tables();
    for (const Given& one : to_.set) check_columns(one, "set.");
    if (to_.steps) check_columns(*to_.steps, "");
    read_references();
    read_metrics(root_, to_);
    order_columns();
    for (Table& table : to_.tables)
      if (table.search) check_formula(table.search->holds, "search." + table.name + ".holds", to_);
    to_.lost = read_when("lost");
    to_.unstable = read_when("unstable");
    read_kept(root_, to_);
    to_.charts = charts::read_charts(root_);
    for (const charts::Chart& chart : to_.charts.all) check_columns(chart);
    root_.refuse_unknown();
  }

 private:
  using Named = std::vector<std::pair<std::string, Section>>;

  void read_tables() {
    const Axes axes(root_);
    auto all = root_.section("tables");
    const bool has_tables = all && !all->table().empty();
    if (!has_tables && !root_.node("search"))
      root_.missing("tables", "a table [tables.NAME] with [[tables.NAME.blocks]], or [[search]]");
    for (auto& [name, section] : has_tables ? all->named_sections() : Named()) {
      Table table = begun(name, section);
      for (Section& block : section.sections("blocks"))
        for (FileValues& row : axes.rows(block, table.columns)) table.rows.push_back(std::move(row));
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

  void read_references() {
    auto all = root_.section("references");
    if (!all) return;
    for (auto& [name, section] : all->named_sections())
      to_.references.push_back(read_reference(name, section));
  }

  Reference read_reference(const std::string& name, Section& section) const {
    Reference one{.name = name, .place = section.place()};
    if (name == "none")
      refuse(section.place(), "a reference has the name none, which stands for no reference");
    if (const auto file = section.text("file")) one.file = to_.file.parent_path() / *file;
    if (const auto scenario = section.text("scenario"))
      one.scenario = Given{"", *scenario, section.place("scenario")};
    one.per = section.texts("per");
    one.floor = *section.flag("floor");
    one.with = all_given(section, "with");
    one.set = all_given(section, "set");
    if (auto outputs = section.section("outputs"))
      for (const auto& [output, node] : text::in_file_order(outputs->table())) {
        if (!node->is_string()) outputs->wrong(output, text::described(*node), "the name of an output");
        one.outputs[output] = node->as_string()->get();
      }
    if (!one.file.empty())
      for (const char* key : {"scenario", "per", "floor", "with", "set"})
        section.leave_out(key, "results are read from `file`");
    section.refuse_unknown();
    for (const std::string& column : one.per) check_column(section.place("per"), section.name("per"), column);
    for (const Given& with : one.with) check_column(with.place, section.name("with"), with.name);
    for (const Given& set : one.set) check_columns(set, section.name("set") + ".");
    return one;
  }

  /// Of a chart of one of its tables. Others may come from elsewhere.
  void check_columns(const charts::Chart& chart) const {
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

  void check_columns(const Given& one, const std::string& table) const {
    for (const std::string& column : one.columns()) check_column(one.place, table + one.name, column);
  }

  void check_column(const Place& place, const std::string& what, const std::string& column) const {
    const auto known = to_.columns();
    if (!has(known, column)) refuse(place, what + ": " + unknown("column", column, known));
  }

  /// Those named first, then the others.
  void order_columns() {
    const auto first = root_.texts("columns");
    std::vector<std::string> metrics, known;
    for (const Metric& metric : to_.metrics) metrics.push_back(metric.name);
    known = metrics;
    for (const Table& table : to_.tables)
      known.insert(known.end(), table.columns.begin(), table.columns.end());
    for (Table& table : to_.tables) {
      if (table.search) {
        table.metrics = without_times();
        table.header = header({}, table);
        table.header.insert(table.header.begin() + static_cast<std::ptrdiff_t>(table.columns.size()),
                            table.search->column);
        continue;
      }
      Section& section = sections_.at(table.name);
      const auto own = section.texts("columns");
      const auto chosen = section.texts("metrics");
      for (const auto& [names, at] : {std::pair(&first, &root_), std::pair(&own, &section)})
        for (const std::string& name : *names)
          if (!has(known, name))
            refuse(at->place("columns"),
                   at->name("columns") + ": " + unknown("column or metric", name, known));
      for (const std::string& name : chosen)
        if (!has(metrics, name))
          refuse(section.place("metrics"), section.name("metrics") + ": " + unknown("metric", name, metrics));
      table.metrics = section.node("metrics") ? chosen : to_.tables.size() == 1 ? metrics : without_times();
      table.header = header(own.empty() ? first : own, table);
      section.refuse_unknown();
    }
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

  const Document& document_;
  Section root_;
  Study& to_;
  std::map<std::string, Section> sections_;  ///< of tables
};

}  // namespace

std::vector<Given> all_given(Section& section, const std::string& key) {
  std::vector<Given> all;
  if (const toml::table* table = section.table(key))
    for (const auto& [name, node] : text::in_file_order(*table))
      all.push_back(given(section.document(), name, *node, section.name(key) + "." + name));
  return all;
}

std::vector<std::string> Given::columns() const {
  const auto* text = std::get_if<std::string>(&value);
  if (!text || !text->starts_with("$")) return {};
  if (!text->starts_with("$(")) return {text->substr(1)};
  return located(place, [&] { return text::names_in(text->substr(2, text->size() - 3)); });
}

text::SetValue Given::with(const FileValues& columns) const {
  const auto* text = std::get_if<std::string>(&value);
  if (!text || !text->starts_with("$")) return value;
  return located(place, [&] {
    const FileValue found = text::referred(*text, columns);
    return std::visit([](const auto& one) { return text::SetValue(one); }, found);
  });
}

std::vector<std::string> Study::columns() const {
  std::vector<std::string> names;
  for (const Table& table : tables) {
    for (const std::string& column : table.columns)
      if (!has(names, column)) names.push_back(column);
    if (table.search && !has(names, table.search->column)) names.push_back(table.search->column);
  }
  return names;
}

std::vector<std::string> Study::columns_of(const Table& table) const {
  std::vector<std::string> all;
  for (const std::string& name : table.header) {
    const auto names = has(table.metrics, name) ? names_of(metric(name)) : std::vector{name};
    all.insert(all.end(), names.begin(), names.end());
  }
  return all;
}

std::vector<std::string> Study::columns_of_series(const Table& table) const {
  std::vector<std::string> all = table.columns;
  all.insert(all.end(), {"kept", "time"});
  const auto add = [&all](const std::string& name) {
    if (!has(all, name)) all.push_back(name);
  };
  for (const Kept& one : kept) {
    if (one.table != table.name) continue;
    for (const std::string& output : one.outputs) add(output);
    for (const std::string& output : one.outputs)
      if (!one.against.empty()) add(output + "." + one.against);
    for (const std::string& drift : one.drifts) add(drift);
  }
  return all;
}

const Reference& Study::reference(const std::string& name) const {
  return *std::find_if(references.begin(), references.end(),
                       [&](const Reference& one) { return one.name == name; });
}

const Metric& Study::metric(const std::string& name) const {
  return *std::find_if(metrics.begin(), metrics.end(), [&](const Metric& one) { return one.name == name; });
}

std::vector<std::string> Study::names_of(const Metric& metric) const {
  std::vector<std::string> names = {metric.name};
  if (metric.window.shift > 0.0) names.push_back(metric.name + ".shift");
  if (!metric.against.empty() && reference(metric.against).floor) names.push_back(metric.name + ".floor");
  if (metric.kind == Metric::Kind::seconds) names.push_back(metric.name + ".processor");
  return names;
}

void Study::keep_tables(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Table& table : tables) known.push_back(table.name);
  for (const std::string& name : names)
    if (!has(known, name))
      throw Error(ErrorCode::invalid_argument, file.string() + ": " + unknown("table", name, known));
  std::erase_if(tables, [&](const Table& table) { return !has(names, table.name); });
  std::erase_if(kept, [&](const Kept& one) { return !has(names, one.table); });
}

bool Study::is_timed(const Table& table) const {
  return std::any_of(table.metrics.begin(), table.metrics.end(),
                     [this](const std::string& name) { return metric(name).is_time(); });
}

static Study read_document(const std::filesystem::path& file, const Document& document) {
  Study study;
  study.file = file;
  if (const auto* inner = document.table().get_as<toml::table>("study"))
    Reader(document, Section(document, keys(), *inner, "study", ""), study).read(false);
  else
    Reader(document, Section(document, keys()), study).read(true);
  return study;
}

Study read(const std::filesystem::path& file) { return read_document(file, Document(file)); }

Study read(const std::filesystem::path& file, const std::string& text) {
  return read_document(file, Document(file.string(), text));
}

}  // namespace tandem::study
