// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tandem/input_file.hpp"
#include "tandem/text/nesting.hpp"
#include "tandem/text/set.hpp"

namespace tandem::text {
namespace {

/// Without the file's text, which the library's own sentence quotes: it may be no TOML at all, and nobody's
/// business. Of "Error while parsing key-value pair: ..." the words before the colon are the library's.
std::string not_toml(const toml::parse_error& error) {
  constexpr std::string_view before = "Error while parsing ";
  const std::string_view said = error.description();
  std::string sentence = "not TOML at column " + std::to_string(error.source().begin.column);
  if (said.starts_with(before) && said.find(':') != std::string_view::npos)
    sentence += " (" + std::string(said.substr(before.size(), said.find(':') - before.size())) + ")";
  const bool again = said.find("redefine") != std::string_view::npos;
  return sentence + (again ? "; it is there twice, allowed is once" : "");
}

}  // namespace

Document::Document(const std::filesystem::path& file)
    : Document(file.string(), read_file(file, longest_document)) {}

Document::Document(std::string name, const std::string& text, std::vector<int> lines)
    : file_(std::move(name)), lines_(std::move(lines)) {
  if (const int line = deeper_than(text, deepest_nesting); line > 0) refuse({file_, line}, too_deep);
  try {
    table_ = toml::parse(std::string_view(text), std::string_view(file_));
  } catch (const toml::parse_error& error) {
    refuse({file_, line(error.source().begin)}, not_toml(error));
  }
}

void Document::set(const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides)
    located(Place{file_, 0, set_prefix + text}, [&] { text::set(table_, text); });
}

void Document::set(const std::string& path, const SetValue& value) {
  located(Place{file_, 0, set_prefix + override_of(path, value)}, [&] { text::set(table_, path, value); });
}

void throw_at(const Place& place, const Error& error) {
  const std::string sentence = error.what();
  if (sentence.starts_with(place.file + ":")) throw;
  if (dynamic_cast<const NoRoom*>(&error)) throw NoRoom(place.text() + ": " + sentence);
  refuse(place, sentence, error.code());
}

int Document::line(const toml::source_position& at) const {
  return at.line > 0 && at.line <= lines_.size() ? lines_[at.line - 1] : static_cast<int>(at.line);
}

Place Document::place(const toml::node& node) const {
  const toml::source_region& source = node.source();
  if (source.path && source.path->starts_with(set_prefix)) return {file_, 0, *source.path};
  return {file_, line(source.begin)};
}

std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [key, node] : table) entries.emplace_back(key.str(), &node);
  const auto position = [](const toml::node* node) {
    const toml::source_region& s = node->source();
    return std::tuple(s.path && s.path->starts_with(set_prefix), s.begin.line, s.begin.column);
  };
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const auto& a, const auto& b) { return position(a.second) < position(b.second); });
  return entries;
}

std::vector<std::string> keys(const toml::table& table) {
  std::vector<std::string> names;
  for (const auto& [key, node] : in_file_order(table)) names.push_back(key);
  return names;
}

std::string described(const toml::node& node) {
  if (const auto* text = node.as_string()) return "the text '" + text->get() + "'";
  if (const auto* number = node.as_floating_point()) return fmt::format("the number {}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("the number {}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return node.is_table() ? "a table" : node.is_array() ? "an array" : "a date or time";
}

}  // namespace tandem::text
