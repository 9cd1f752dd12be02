// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "fingerprint.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/text/document.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 4096;

std::uint64_t sum_of(const std::string& text, std::uint64_t sum) {
  return checksum(std::as_bytes(std::span(text.data(), text.size() + 1)), sum);
}

std::uint64_t sum_of_file(const fs::path& file, std::uint64_t sum) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> block(std::size_t{1} << 16);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())), in.gcount() > 0)
    sum = checksum(std::as_bytes(std::span(block.data(), static_cast<std::size_t>(in.gcount()))), sum);
  return sum_of(file.string(), sum);
}

/// The texts in JSON and in TOML.
void add_texts(const nlohmann::json& json, std::vector<std::string>& to) {
  if (json.is_string()) to.push_back(json.get<std::string>());
  if (json.is_structured())
    for (const auto& inner : json) add_texts(inner, to);
}
void add_texts(const toml::node& node, std::vector<std::string>& to) {
  if (const auto* text = node.as_string()) to.push_back(text->get());
  if (const auto* table = node.as_table())
    for (const auto& [key, inner] : *table) add_texts(inner, to);
  if (const auto* array = node.as_array())
    for (const toml::node& inner : *array) add_texts(inner, to);
}

}  // namespace

void Fingerprint::add(const fs::path& file) {
  std::error_code unreadable;
  const fs::path whole = fs::weakly_canonical(file, unreadable);
  if (unreadable || !fs::is_regular_file(whole, unreadable) || !files_.insert(whole).second) return;
  if (whole.extension() != ".toml") return;
  std::vector<std::string> texts;
  try {
    add_texts(text::Document(whole).table(), texts);
  } catch (const Error&) {  // no TOML: a file like others
  }
  for (const std::string& text : texts) add_named(text, whole.parent_path());
}

void Fingerprint::add(const scenario::Scenario& scenario) {
  add(scenario.file);
  std::vector<std::string> texts;
  add_texts(nlohmann::json::parse(scenario.values), texts);
  for (const std::string& text : texts) add_named(text, scenario.file.parent_path());
}

/// "mechanism:linkage.toml?step=1", "motor.c", or a text that names no file.
void Fingerprint::add_named(const std::string& text, const fs::path& folder) {
  const bool is_name = !text.empty() && text.size() <= longest_name && text.find('\0') == std::string::npos;
  if (!is_name || !seen_.insert(folder.string() + '\n' + text).second) return;
  const SourceUri uri(text);
  add(folder / text.substr(0, text.find('?')));
  if (!uri.scheme.empty()) add(folder / uri.place);
}

std::string Fingerprint::text(const std::vector<std::string>& overrides, std::uint64_t seed) const {
  std::uint64_t sum =
      sum_of_file("/proc/self/exe", empty_checksum);  // Linux; elsewhere the program is not looked at
  for (const std::string& one : overrides) sum = sum_of(one, sum);
  sum = sum_of(std::to_string(seed), sum);
  for (const fs::path& file : files_) sum = sum_of_file(file, sum);
  return fmt::format("{:016x}", sum);
}

}  // namespace tandem::study
