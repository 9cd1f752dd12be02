// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/json.hpp"

#include <algorithm>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/provenance.hpp"

namespace tandem::output {
namespace {

constexpr std::uint64_t longest = std::uint64_t{1} << 26;  // bytes

/// By its brackets outside of texts.
int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++k;
    if (quoted) continue;
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return deepest;
}

[[noreturn]] void refuse_json(const std::string& name, const std::string& why) {
  throw Error(ErrorCode::input_output, name + " " + why);
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& name) {
  if (depth_of(text) > deepest_json)
    refuse_json(name,
                "has objects and arrays in each other more than " + std::to_string(deepest_json) + " deep");
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view before = text.substr(0, std::max<std::size_t>(error.byte, 1) - 1);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    refuse_json(name, "is not JSON: line " + std::to_string(line) + ", column " +
                          std::to_string(before.size() - before.rfind('\n')));
  } catch (const nlohmann::json::out_of_range&) {  // its sentence quotes the number, and names no file
    refuse_json(name, "has a number that is too large; allowed are those of 64 bits");
  }
}

nlohmann::json read_json(const std::filesystem::path& file) {
  return parse_json(read_file(file, longest), "file '" + file.string() + "'");
}

nlohmann::ordered_json made() {
  return {{"tandem", version()},
          {"commit", source_commit()},
          {"compiler", compiler()},
          {"processor", processor_model()}};
}

}  // namespace tandem::output
