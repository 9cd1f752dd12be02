// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

namespace tandem::text {
namespace {

std::string read_text(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw Error(ErrorCode::input_output, "file '" + file.string() + "' is not there");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || std::filesystem::is_directory(file))
    throw Error(ErrorCode::input_output, "file '" + file.string() + "' can't be read");
  return text.str();
}

/// What the words of the library mean where a port or block is there twice.
const char* twice(const toml::parse_error& error) {
  const bool again = error.description().find("redefine") != std::string_view::npos;
  return again ? "; it is there twice, allowed is once" : "";
}

}  // namespace

Document::Document(const std::filesystem::path& file) : Document(file.string(), read_text(file)) {}

Document::Document(std::string name, const std::string& text) : file_(std::move(name)) {
  try {
    table_ = toml::parse(std::string_view(text), std::string_view(file_));
  } catch (const toml::parse_error& error) {
    refuse({file_, static_cast<int>(error.source().begin.line)},
           "not TOML: " + std::string(error.description()) + twice(error));
  }
}

Place Document::place(const toml::node& node) const {
  const toml::source_region& source = node.source();
  if (source.path && source.path->starts_with(set_prefix)) return {file_, 0, *source.path};
  return {file_, static_cast<int>(source.begin.line)};
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
