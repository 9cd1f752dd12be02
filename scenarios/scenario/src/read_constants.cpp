// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_constants.hpp"

#include <algorithm>
#include <set>

#include "tandem/nearest.hpp"

namespace tandem::scenario {
namespace {

/// The names that a text which stands for a number has. Of one that can't be read there are none: reading it as a
/// number tells why.
std::vector<std::string> names_in(const toml::node& node) {
  if (!text::Values::refers(node)) return {};
  const std::string& text = node.as_string()->get();
  if (!text.starts_with("$(")) return {text.substr(1)};
  try {
    return text::names_in(text.substr(2, text.size() - 3));
  } catch (const Error&) {
    return {};
  }
}

void add_names(const toml::node& node, std::set<std::string>& to) {
  for (std::string& name : names_in(node)) to.insert(std::move(name));
  if (const auto* table = node.as_table())
    for (const auto& entry : *table) add_names(entry.second, to);
  if (const auto* array = node.as_array())
    for (const toml::node& entry : *array) add_names(entry, to);
}

}  // namespace

std::set<std::string> named_constants(const text::Document& document) {
  std::set<std::string> named;
  const auto* table = document.table().get_as<toml::table>("constants");
  if (!table) return named;
  add_names(document.table(), named);
  for (const auto& [key, node] : *table)
    if (const std::string name(key.str()); !document.place(node).set_by.empty() && !named.contains(name))
      text::refuse(document.place(node), unknown("constant", name, {named.begin(), named.end()}));
  return named;
}

/// Each needs another one of these.
[[noreturn]] static void refuse_circle(const text::Document& document,
                                       const std::vector<std::pair<std::string, const toml::node*>>& all) {
  std::vector<std::string> names;
  for (const auto& [name, node] : all) names.push_back(name);
  text::refuse(document.place(*all[0].second), "constants need each other in a circle, or what is in one: " +
                                                   listed(names) + "; allowed are constants of others");
}

std::vector<std::pair<std::string, double>> read_constants(text::Section& root, text::Values& to) {
  const auto* table = root.table("constants");
  if (!table) return {};
  std::vector<std::pair<std::string, double>> numbers;
  auto left = text::in_file_order(*table);
  std::set<std::string> known;
  const auto read = [&](const auto& entry) {
    if (text::is_reserved(entry.first))
      text::refuse(
          root.document().place(*entry.second),
          "constant '" + entry.first + "' has a name that expressions have already; allowed is another");
    const double value = root.number_of(*entry.second, "constants." + entry.first);
    to.set(entry.first, value);
    if (entry.second->is_number()) numbers.emplace_back(entry.first, value);
    known.insert(entry.first);
  };
  const auto read_ready = [&](const auto& entry) {
    const auto names = names_in(*entry.second);
    const bool ready = std::all_of(names.begin(), names.end(),
                                   [&](const std::string& name) { return known.contains(name); });
    if (ready) read(entry);
    return ready;
  };
  while (std::erase_if(left, read_ready) > 0) {
  }
  std::set<std::string> there = known;
  for (const auto& [name, node] : left) there.insert(name);
  const auto lacks = [&](const auto& entry) {
    return std::ranges::any_of(names_in(*entry.second),
                               [&](const auto& name) { return !there.contains(name); });
  };
  if (const auto wrong = std::ranges::find_if(left, lacks); wrong != left.end())
    read(*wrong);  // which refuses it, by the name that is not there
  if (!left.empty()) refuse_circle(root.document(), left);
  return numbers;
}

}  // namespace tandem::scenario
