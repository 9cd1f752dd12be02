// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "tandem/nearest.hpp"

namespace tandem::text {

Section::Section(const Document& document, const toml::table& table, std::string path, const Values* values)
    : document_(document), table_(table), path_(std::move(path)), values_(values) {}

Section::Section(const Document& document, const Keys& language, const Values* values)
    : document_(document), table_(document.table()), values_(values), language_(&language) {}

Section::Section(const Document& document, const Keys& language, const toml::table& table, std::string path,
                 std::string pattern)
    : document_(document),
      table_(table),
      path_(std::move(path)),
      values_(nullptr),
      language_(&language),
      pattern_(std::move(pattern)) {}

Section::Section(const Section& outer, const toml::table& table, std::string path, std::string pattern)
    : document_(outer.document_),
      table_(table),
      path_(std::move(path)),
      values_(outer.values_),
      language_(outer.language_),
      pattern_(std::move(pattern)) {}

/// As the language has it; null without one.
const Key* Section::known(const std::string& key) const {
  if (!language_) return nullptr;
  const std::string path = pattern_.empty() ? key : pattern_ + "." + key;
  for (const std::string& known : {path, path + "[]"})
    if (const Key* found = language_->find(known, kind_)) return found;
  throw std::logic_error("key '" + path + "' is read and stands in no list of keys");
}

/// What holds where it is not there, as the language has it.
std::optional<std::string> Section::otherwise(const std::string& key) const {
  const Key* const known = this->known(key);
  return known && !known->otherwise.empty() ? std::optional(known->otherwise) : std::nullopt;
}

const toml::node* Section::node(const std::string& key) {
  known(key);
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
  if (!found) return otherwise(key);
  if (!found->is_string()) wrong(key, described(*found), "a text in quotes");
  const std::string word = text_of(*found, key);
  if (const Key* known = this->known(key); known && known->type == Key::Type::word)
    check_word(*known, key, word);
  return word;
}

std::string Section::text_of(const toml::node& node, const std::string& key) const {
  if (!values_) return node.as_string()->get();
  if (!Values::refers(node)) return Values::literal(node.as_string()->get());
  const FileValue value = values_->value(document_, node, name(key));
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  wrong(key, "'" + node.as_string()->get() + "', a number", "a parameter with a text");
}

std::string Section::kind() {
  kind_ = required_text("kind");
  return kind_;
}

void Section::leave_out(const std::string& key, const std::string& why) {
  if (node(key)) refuse(place(key), name(key) + " has no meaning: " + why);
}

void Section::check_word(const Key& known, const std::string& key, const std::string& word) const {
  if (known.allows(word)) return;
  const std::string near = nearest(word, known.words);
  wrong(key, "'" + word + "'" + (near.empty() ? "" : " (did you mean '" + near + "'?)"), described(known));
}

std::string Section::required_text(const std::string& key) {
  if (!node(key)) missing(key);
  return *text(key);
}

double Section::required_number(const std::string& key) {
  if (!node(key)) missing(key);
  return known(key)->type == Key::Type::positive ? *positive(key) : *number(key);
}

void Section::missing(const std::string& key) const {
  const Key& known = *this->known(key);
  missing(key, described(known));
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
  if (found) return number_of(*found, name(key));
  const auto value = otherwise(key);
  return value ? std::optional(std::stod(*value)) : std::nullopt;
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
  if (!found) {
    const auto value = otherwise(key);
    return value ? std::optional(*value == "true") : std::nullopt;
  }
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
    all.push_back(language_ && language_->refer_in_arrays() ? text_of(element, key)
                                                            : element.as_string()->get());
  }
  return all;
}

const toml::table* Section::table(const std::string& key) {
  const toml::node* found = node(key);
  if (found && !found->is_table()) wrong(key, described(*found), "a table");
  return found ? found->as_table() : nullptr;
}

std::optional<Section> Section::section(const std::string& key) {
  const toml::table* inner = table(key);
  return inner ? std::optional(Section(*this, *inner, name(key), known(key)->path)) : std::nullopt;
}

std::vector<std::pair<std::string, Section>> Section::named_sections() {
  std::vector<std::pair<std::string, Section>> all;
  for (const auto& [key, found] : in_file_order(table_)) all.emplace_back(key, of_name(key));
  return all;
}

Section Section::of_name(const std::string& key) {
  const toml::node& found = *table_.get(key);
  if (!found.is_table()) wrong(key, described(found), "a table");
  return {*this, *found.as_table(), name(key), known("NAME")->path};
}

std::vector<Section> Section::sections(const std::string& key) {
  std::vector<Section> all;
  const toml::node* found = node(key);
  if (!found) return all;
  const toml::array* array = found->as_array();
  if (!array || !(array->empty() || array->is_array_of_tables()))
    wrong(key, described(*found), "an array of tables, each begun by [[" + name(key) + "]]");
  for (std::size_t i = 0; i < array->size(); ++i)
    all.push_back(
        {*this, *array->get(i)->as_table(), name(key) + "[" + std::to_string(i) + "]", known(key)->path});
  return all;
}

/// Keys of the language that are not read would be passed over in silence.
void Section::refuse_unread() const {
  for (const Key* known : language_->in(pattern_, kind_))
    if (const std::string key = name_of(*known);
        key != "NAME" && std::find(asked_.begin(), asked_.end(), key) == asked_.end())
      throw std::logic_error("key '" + name(key) + "' stands in the list of keys and is not read");
}

void Section::refuse_unknown() const {
  if (language_) refuse_unread();
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
