// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <random>
#include <span>

#include "tandem/bytes.hpp"
#include "tandem/nearest.hpp"

namespace tandem::study {
namespace {

using text::described;
using text::Document;
using text::Section;

constexpr std::size_t most_rows = 1'000'000;

/// Numbers from 0 to 1: the same for the same column and seed.
class Drawn {
 public:
  Drawn(const std::string& column, std::uint64_t seed)
      : random_(checksum(std::as_bytes(std::span(column)), empty_checksum + seed)) {}
  double next() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }

 private:
  std::mt19937_64 random_;
};

/// { from, to, count, spacing }; both ends as they stand there, unless values are drawn.
std::vector<FileValue> range(Section section, const std::string& column, std::uint64_t seed) {
  const auto from = section.number("from"), to = section.number("to"), count = section.number("count");
  const std::string spacing = section.text("spacing").value_or("linear");
  if (!from || !to || !count) section.missing(!from ? "from" : !to ? "to" : "count", "from, to and count");
  section.refuse_unknown();
  const bool log = spacing == "log" || spacing == "drawn_log", drawn = spacing.starts_with("drawn");
  if (spacing != "linear" && spacing != "drawn" && !log)
    section.wrong("spacing", "'" + spacing + "'", "linear, log, drawn or drawn_log");
  if (*count < 2 || *count > most_rows || *count != std::floor(*count))
    section.wrong("count", fmt::format("{}", *count), fmt::format("a whole number from 2 to {}", most_rows));
  if (log && (*from <= 0.0 || *to <= 0.0))
    section.wrong("from", fmt::format("{} to {}", *from, *to), "ends above 0, with log");
  const auto value = [&](double s) {
    return log ? *from * std::pow(*to / *from, s) : *from + s * (*to - *from);
  };
  std::vector<FileValue> values;
  Drawn random(column, seed);
  for (double k = 0.0; k < *count; ++k)
    values.emplace_back(drawn               ? value(random.next())
                        : k == 0.0          ? *from
                        : k == *count - 1.0 ? *to
                        : log               ? value(k / (*count - 1.0))
                                            : *from + k * (*to - *from) / (*count - 1.0));
  return values;
}

}  // namespace

bool is_column_name(const std::string& name) {
  const auto in_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         std::all_of(name.begin(), name.end(), in_name);
}

void refuse_own_column(const std::string& what, const std::string& name, const text::Place& place) {
  if (name == "status" || name == "note")
    refuse(place, what + " has the name of a column that each table has at its end; allowed is another");
}

Axes::Axes(Section& root, std::uint64_t seed) : seed_(seed) {
  const toml::table* lists = root.table("lists");
  if (!lists) return;
  const Document& document = root.document();
  for (const auto& [name, node] : text::in_file_order(*lists)) {
    const auto* inner = node->as_table();
    lists_[name] = inner && !inner->contains("range")
                       ? table(document, *inner, "lists." + name)
                       : Axis{{name}, {column(document, *node, "lists." + name)}};
  }
}

Axis Axes::axis(const Section& block, const toml::node& node) const {
  const std::string what = block.name("axes");
  if (const auto* inner = node.as_table()) return table(block.document(), *inner, what);
  if (!node.is_string())
    refuse(block.document().place(node),
           what + " holds " + described(node) + "; allowed are tables and names of lists");
  const std::string name = node.as_string()->get();
  if (const auto it = lists_.find(name); it != lists_.end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [list, values] : lists_) known.push_back(list);
  refuse(block.document().place(node), what + ": " + unknown("list", name, known));
}

Axis Axes::table(const Document& document, const toml::table& table, const std::string& name) const {
  Axis axis;
  for (const auto& [key, node] : text::in_file_order(table)) {
    if (!is_column_name(key))
      refuse(document.place(*node),
             name + ": column '" + key + "'; allowed are letters, digits and _, no digit first");
    refuse_own_column(name + "." + std::string(key), std::string(key), document.place(*node));
    axis.columns.push_back(key);
    axis.values.push_back(column(document, *node, name + "." + key));
    if (axis.values.back().size() != axis.values.front().size())
      refuse(document.place(*node),
             fmt::format("{}: {} has {} values and {} has {}; allowed are equally many in columns that "
                         "move together",
                         name, key, axis.values.back().size(), axis.columns.front(),
                         axis.values.front().size()));
  }
  if (axis.columns.empty())
    refuse(document.place(table), name + " is empty; allowed is a column with its values");
  return axis;
}

std::vector<FileValue> Axes::column(const Document& document, const toml::node& node,
                                    const std::string& name) const {
  if (const auto* inner = node.as_table();
      inner && inner->contains("range") && inner->get("range")->is_table())
    return range(Section(document, *inner->get("range")->as_table(), name + ".range"),
                 name.substr(name.rfind('.') + 1), seed_);
  if (const auto* text = node.as_string(); text && text->get().starts_with("$"))
    if (const auto it = lists_.find(text->get().substr(1));
        it != lists_.end() && it->second.values.size() == 1)
      return it->second.values[0];
  const auto* array = node.as_array();
  if (!array || array->empty())
    refuse(document.place(node),
           name + " is " + (array ? "empty" : described(node)) +
               "; allowed is an array of values, \"$LIST\" of a list that is one, or { range = .. }");
  std::vector<FileValue> values;
  for (const toml::node& value : *array)
    if (const auto* word = value.as_string())
      values.emplace_back(word->get());
    else
      values.emplace_back(text::number_of(document, value, name));
  return values;
}

std::vector<FileValues> Axes::rows(Section& block, std::vector<std::string>& columns) const {
  const toml::node* node = block.node("axes");
  if (!node) block.missing("axes");
  if (!node->is_array() || node->as_array()->empty())
    block.wrong("axes", described(*node), "an array of tables and names of lists");
  std::vector<FileValues> rows(1);
  for (const toml::node& one : *node->as_array()) {
    const Axis axis = this->axis(block, one);
    for (const std::string& column : axis.columns) {
      if (rows[0].contains(column))
        refuse(block.document().place(one), block.name("axes") + ": column " + column + " is there twice");
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
    }
    if (rows.size() * axis.values[0].size() > most_rows)
      refuse(block.document().place(one),
             fmt::format("{}: more than {} rows", block.name("axes"), most_rows));
    std::vector<FileValues> longer;
    for (const FileValues& row : rows)
      for (std::size_t k = 0; k < axis.values[0].size(); ++k) {
        longer.push_back(row);
        for (std::size_t c = 0; c < axis.columns.size(); ++c)
          longer.back()[axis.columns[c]] = axis.values[c][k];
      }
    rows = std::move(longer);
  }
  if (const auto where = block.text("where"))
    located(block.place("where"), [&] {
      std::erase_if(rows, [&](const FileValues& row) { return text::evaluated(*where, row) == 0.0; });
    });
  block.refuse_unknown();
  return rows;
}

}  // namespace tandem::study
