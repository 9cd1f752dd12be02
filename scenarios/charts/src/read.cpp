// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "read_values.hpp"

namespace tandem::charts {
namespace {

constexpr std::size_t most_panels_across = 12;

class Reader {
 public:
  explicit Reader(Section& section) : section_(section) {}

  Chart read() {
    chart_.place = section_.place();
    chart_.name = section_.required_text("name");
    check_name();
    using enum Chart::Kind;
    const std::string kind = section_.kind();
    chart_.kind = kind == "curves"  ? curves
                  : kind == "work"  ? work
                  : kind == "map"   ? map
                  : kind == "table" ? table
                                    : traces;
    chart_.table = table_name(section_, section_.text("table").value_or(""));
    chart_.title = section_.text("title").value_or("");
    chart_.notes = section_.texts("notes");
    if (const toml::table* words = section_.table("words"))
      chart_.names = names_in(section_, *words, "words");
    chart_.where = quantity(section_, "where");
    if (chart_.kind == curves) read_curves();
    if (chart_.kind == work) read_work();
    if (chart_.kind == map) read_map();
    if (chart_.kind == traces) read_traces();
    if (chart_.kind == table) read_table();
    section_.refuse_unknown();
    return chart_;
  }

 private:
  /// A table of the folder, and of no other: TABLE, or TABLE.series.
  static std::string table_name(const Section& section, const std::string& name) {
    const auto is_allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; };
    if (name.starts_with('.') || !std::all_of(name.begin(), name.end(), is_allowed))
      section.wrong("table", "'" + name + "'", "letters, digits, _ and dots, no dot first");
    return name;
  }

  void check_name() {
    const auto is_allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (chart_.name.empty() || !std::all_of(chart_.name.begin(), chart_.name.end(), is_allowed))
      section_.wrong("name", "'" + chart_.name + "'", "letters, digits and _");
  }

  void read_panels() {
    chart_.panels = one_or_more(section_, "panels");
    const double across = section_.positive("across").value_or(0.0);
    if (across != std::floor(across) || across > most_panels_across)
      section_.wrong("across", fmt::format("{}", across),
                     fmt::format("a whole number up to {}", most_panels_across));
    chart_.across = static_cast<int>(across);
  }

  void read_curves() {
    const auto x = quantity(section_, "x");
    if (!x) section_.missing("x");
    for (auto& y : quantities(section_, "y")) chart_.x.push_back(*x), chart_.y.push_back(std::move(y));
    chart_.colour = chart_.marker = one_or_more(section_, "series");
    for (const std::string& axis : one_or_more(section_, "log")) {
      if (axis != "x" && axis != "y")
        section_.wrong("log", "'" + axis + "'", "\"x\", \"y\", or an array of both");
      (axis == "x" ? chart_.log_x : chart_.log_y) = true;
    }
    chart_.joined = true;
    read_points();
  }

  void read_work() {
    const auto costs = quantities(section_, "cost"), errors = quantities(section_, "error");
    for (const auto& error : errors)
      for (const auto& cost : costs) chart_.x.push_back(cost.front()), chart_.y.push_back(error);
    chart_.colour = one_or_more(section_, "colour");
    chart_.marker = one_or_more(section_, "marker");
    chart_.log_x = chart_.log_y = true;
    chart_.joined = *section_.flag("join");
    chart_.front = *section_.flag("front");
    read_points();
  }

  void read_points() {
    read_panels();
    chart_.percent = *section_.flag("percent");
    chart_.limit = section_.positive("limit");
    chart_.tolerance = section_.positive("tolerance");
    chart_.hollow = quantity(section_, "hollow"), chart_.floor = quantity(section_, "floor");
    chart_.slopes = numbers(section_, "slope");
    tables(section_, "lines", [&](Section& line) {
      chart_.lines.push_back({line.number("x"), line.number("y"), line.text("name").value_or("")});
      if (chart_.lines.back().x.has_value() == chart_.lines.back().y.has_value())
        refuse(line.place(), line.path() + " needs one of x and y");
    });
    if (const toml::table* table = section_.table("overlay")) {
      Section overlay(section_.document(), *table, section_.name("overlay"));
      chart_.overlay = {table_name(overlay, overlay.required_text("table", "a table")),
                        overlay.required_text("name", "a text"), quantity(overlay, "where")};
      overlay.refuse_unknown();
    }
  }

  static Sign sign_in(Section& section) {
    const auto when = quantity(section, "when");
    if (!when) section.missing("when", "an expression");
    return {*when, section.required_text("name", "a text")};
  }

  void read_map() {
    constexpr std::size_t most_shades = 6, most_signs = 3;
    chart_.rows = one_or_more(section_, "rows");
    if (chart_.rows.empty()) section_.missing("rows");
    chart_.columns = section_.required_text("columns");
    chart_.value = quantity(section_, "value");
    if (!chart_.value) section_.missing("value");
    chart_.limits = numbers(section_, "limits");
    if (chart_.limits.empty() || chart_.limits.size() > most_shades ||
        !std::is_sorted(chart_.limits.begin(), chart_.limits.end()))
      section_.wrong("limits", "something else", "one to six numbers, rising");
    chart_.percent = *section_.flag("percent");
    tables(section_, "signs", [&](Section& sign) { chart_.signs.push_back(sign_in(sign)); });
    if (chart_.signs.size() > most_signs) section_.wrong("signs", "more", "up to three");
    chart_.text = section_.text("text").value_or("");
    chart_.best = section_.positive("best");
    if (const toml::table* table = section_.table("also")) {
      Section also(section_.document(), *table, section_.name("also"));
      chart_.also = sign_in(also);
      also.refuse_unknown();
    }
    read_panels();
  }

  void read_table() {
    constexpr double most_digits = 17.0;
    chart_.rows = one_or_more(section_, "rows");
    if (chart_.rows.empty()) section_.missing("rows");
    chart_.columns = section_.text("columns").value_or("");
    chart_.y = quantities(section_, "cells");
    chart_.each = one_or_more(section_, "each");
    static const std::vector<std::string> known = {"sum", "mean", "least", "most"};
    for (const std::string& one : chart_.each)
      if (std::find(known.begin(), known.end(), one) == known.end())
        section_.wrong("each", "'" + one + "'", "sum, mean, least or most");
    if (chart_.each.size() > 1 && chart_.each.size() != chart_.y.size())
      section_.wrong("each", fmt::format("{} words", chart_.each.size()),
                     fmt::format("one, or as many as cells has ({})", chart_.y.size()));
    const double digits = *section_.positive("digits");
    if (digits != std::floor(digits) || digits > most_digits)
      section_.wrong("digits", fmt::format("{}", digits), "a whole number up to 17");
    chart_.digits = static_cast<int>(digits);
  }

  void read_traces() {
    chart_.y = quantities(section_, "y");
    chart_.x.assign(chart_.y.size(), {section_.text("x").value(), section_.place("x")});
    chart_.series = one_or_more(section_, "series");
    chart_.panels = one_or_more(section_, "panels");
    chart_.difference = section_.text("difference").value_or("");
    chart_.jumps = section_.text("jumps").value_or("");
    const toml::node* windows = section_.node("windows");
    if (!windows) return;
    if (!windows->is_array()) section_.wrong("windows", text::described(*windows), "an array of [FROM, TO]");
    for (const toml::node& one : *windows->as_array()) {
      const toml::array* ends = one.as_array();
      if (!ends || ends->size() != 2) section_.wrong("windows", "something else", "an array of [FROM, TO]");
      const double from = section_.number_of(*ends->get(0), section_.name("windows")),
                   to = section_.number_of(*ends->get(1), section_.name("windows"));
      if (!(from < to)) section_.wrong("windows", fmt::format("[{}, {}]", from, to), "FROM below TO");
      chart_.windows.push_back({from, to});
    }
  }

  Section& section_;
  Chart chart_;
};

}  // namespace

const std::string& Charts::name_of(const std::string& word) const {
  const auto it = names.find(word);
  return it == names.end() ? word : it->second;
}

Charts read_charts(Section& root) {
  Charts charts;
  charts.beside = std::filesystem::path(root.document().file()).parent_path();
  if (const toml::table* names = root.table("names")) charts.names = names_in(root, *names, "names");
  for (Section& section : root.sections("charts")) {
    charts.all.push_back(Reader(section).read());
    const Chart& one = charts.all.back();
    if (std::count_if(charts.all.begin(), charts.all.end(),
                      [&](const Chart& c) { return c.name == one.name; }) > 1)
      section.wrong("name", "'" + one.name + "', which another chart has", "a name of its own");
  }
  return charts;
}

}  // namespace tandem::charts
