// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/style.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tandem/error.hpp"
#include "tandem/output/json.hpp"

namespace tandem::charts {
namespace {

constexpr double size = 0.55;

struct Mark {
  const char* colour;
  const char* dashes;
  int hollow;  // gnuplot's point type; the filled one is the next
};

constexpr std::array<Mark, 6> marks = {{{"#000000", "1", 6},
                                        {"#E69F00", "'-'", 8},
                                        {"#56B4E9", "'_-'", 4},
                                        {"#D55E00", "1", 12},
                                        {"#0072B2", "'.'", 10},
                                        {"#009E73", "'-.'", 14}}};

std::string value_of(const nlohmann::json& conditions, const std::string& key,
                     const std::filesystem::path& file) {
  if (!conditions.is_object() || !conditions.contains(key))
    throw Error(ErrorCode::input_output, "file '" + file.string() + "': key '" + key + "' is missing");
  return conditions[key].is_string() ? conditions[key].get<std::string>() : conditions[key].dump();
}

}  // namespace

std::string line_of(int k) {
  return fmt::format("lc rgb '{}' lw 1.6 dt {}", marks.at(k).colour, marks.at(k).dashes);
}

std::string marker_of(int k) {
  return fmt::format("lc rgb '{}' pt {} ps {}", marks.at(k).colour, marks.at(k).hollow + 1, size);
}

std::string white_marker_of(int k) {
  return fmt::format("lc rgb 'white' pt {} ps {}", marks.at(k).hollow + 1, size);
}

std::string hollow_marker_of(int k) {
  return fmt::format("lc rgb '{}' pt {} ps {} lw 1.2", marks.at(k).colour, marks.at(k).hollow, size);
}

std::string line_and_marker_of(int k) {
  return fmt::format("{} pt {} ps {}", line_of(k), marks.at(k).hollow + 1, size);
}

std::vector<std::string> conditions_caption(const std::filesystem::path& file, std::size_t width) {
  const auto conditions = output::read_json(file);
  const std::pair<const char*, const char*> keys[] = {
      {"processor", "processor"}, {"compiler", "compiler"},     {"commit", "commit"},
      {"reference", "reference"}, {"error_norm", "error norm"}, {"repetitions", "repetitions"}};
  std::vector<std::string> lines(1);
  for (const auto& [key, name] : keys) {
    const std::string part = fmt::format("{}: {}", name, value_of(conditions, key, file));
    if (!lines.back().empty() && lines.back().size() + part.size() + 3 > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : "   ") + part;
  }
  return lines;
}

double conditions_number(const std::filesystem::path& file, const std::string& key) {
  const auto conditions = output::read_json(file);
  const std::string text = value_of(conditions, key, file);
  if (!conditions[key].is_number())
    throw Error(ErrorCode::input_output,
                "file '" + file.string() + "': " + key + " is " + text + "; allowed is a number");
  return conditions[key].get<double>();
}

}  // namespace tandem::charts
