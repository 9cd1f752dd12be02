// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tandem/nearest.hpp"

namespace tandem::text {

Section::Section(const Document& document, const toml::table& table, std::string path, const Values* values)
    : document_(document), table_(table), path_(std::move(path)), values_(values) {}

const toml::node* Section::node(const std::string& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  return table_.get(key);
}

Place Section::place(const std::string& key) const {
  const toml::node* node = table_.get(key);
  return document_.place(node ? *node : table_);
}

void Section::wrong(const std::string& key, const std::string& found, const std::string& allowed) const {
  refuse(place(key), name(key) + " is " + found + "; allowed is " + allowed);
}

std::optional<std::string> Section::text(const std::string& key) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  if (!found->is_string()) wrong(key, described(*found), "a text in quotes");
  if (!values_ || !Values::refers(*found)) return found->as_string()->get();
  const FileValue value = values_->value(document_, *found, name(key));
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  wrong(key, "'" + found->as_string()->get() + "', a number", "a parameter with a text");
}

std::string Section::required_text(const std::string& key, const std::string& allowed) {
  const auto found = text(key);
  if (!found) missing(key, allowed);
  return *found;
}

void Section::missing(const std::string& key, const std::string& allowed) const {
  for (const std::string& found : keys(table_))
    if (std::find(asked_.begin(), asked_.end(), found) == asked_.end() && !nearest(found, {key}).empty())
      refuse_key(found, key);
  refuse(place(), name(key) + " is missing; allowed is " + allowed);
}

std::optional<double> Section::number(const std::string& key) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  return number_of(*found, name(key));
}

double Section::number_of(const toml::node& node, const std::string& name) const {
  return values_ ? values_->number(document_, node, name) : text::number_of(document_, node, name);
}

std::optional<double> Section::positive(const std::string& key) {
  const auto found = number(key);
  if (found && *found <= 0.0) {
    const toml::node& node = *table_.get(key);
    wrong(key, node.is_number() ? described(node) : described(node) + fmt::format(", {}", *found),
          "a number above 0");
  }
  return found;
}

std::optional<bool> Section::flag(const std::string& key) {
  const toml::node* found = node(key);
  if (!found) return std::nullopt;
  if (!found->is_boolean()) wrong(key, described(*found), "true or false");
  return found->as_boolean()->get();
}

std::vector<std::string> Section::texts(const std::string& key) {
  std::vector<std::string> all;
  const toml::node* found = node(key);
  if (!found) return all;
  if (!found->is_array()) wrong(key, described(*found), "an array of texts");
  for (const toml::node& element : *found->as_array()) {
    if (!element.is_string())
      refuse(document_.place(element),
             name(key) + " holds " + described(element) + "; allowed are texts in quotes");
    all.push_back(element.as_string()->get());
  }
  return all;
}

const toml::table* Section::table(const std::string& key) {
  const toml::node* found = node(key);
  if (found && !found->is_table()) wrong(key, described(*found), "a table");
  return found ? found->as_table() : nullptr;
}

void Section::refuse_unknown() const {
  for (const auto& [key, found] : in_file_order(table_)) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    refuse_key(key, nearest(key, asked_));
  }
}

void Section::refuse_key(const std::string& key, const std::string& near) const {
  const std::string where = path_.empty() ? "key" : "key of [" + path_ + "]";
  refuse(place(key), "unknown " + where + " '" + key + "'" +
                         (near.empty() ? "." : "; did you mean '" + near + "'?") +
                         " Allowed are: " + listed(asked_));
}

double number_of(const Document& document, const toml::node& node, const std::string& name) {
  const auto fail = [&](const std::string& allowed) {
    refuse(document.place(node), name + " is " + described(node) + "; allowed is " + allowed);
  };
  constexpr std::int64_t largest_whole = std::int64_t{1} << std::numeric_limits<double>::digits;
  if (const auto* whole = node.as_integer()) {
    if (std::abs(whole->get()) > largest_whole) fail("a whole number up to 2^53");
    return static_cast<double>(whole->get());
  }
  if (!node.is_floating_point()) fail("a number");
  const double value = node.as_floating_point()->get();
  if (!std::isfinite(value)) fail("a finite number");
  return value;
}

}  // namespace tandem::text
