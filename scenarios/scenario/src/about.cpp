// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/about.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/output/json.hpp"

namespace tandem::scenario {
namespace {

namespace fs = std::filesystem;
using Type = nlohmann::json::value_t;

[[noreturn]] void refuse_about(const std::string& sentence) {
  throw Error(ErrorCode::input_output, sentence);
}

struct Key {
  const char* path;
  Type type;
  bool required = false;
  Type elements = Type::null;  ///< null: any
};

constexpr Key about_keys[] = {{"", Type::object, true},
                              {"/files", Type::array, true, Type::string},
                              {"/status", Type::string},
                              {"/message", Type::string},
                              {"/notes", Type::array},
                              {"/units", Type::object, false, Type::string},
                              {"/interpolation", Type::object, false, Type::string},
                              {"/versions", Type::object, false, Type::string},
                              {"/indicators", Type::object},
                              {"/indicators/defects", Type::object, false, Type::object},
                              {"/indicators/energies", Type::object, false, Type::object},
                              {"/coordination", Type::object},
                              {"/coordination/schedule", Type::string},
                              {"/scenario", Type::object, true},
                              {"/scenario/file", Type::string},
                              {"/scenario/name", Type::string},
                              {"/scenario/overrides", Type::array, false, Type::string},
                              {"/scenario/values", Type::object, true},
                              {"/scenario/values/description", Type::string},
                              {"/scenario/values/subsystems", Type::object, false, Type::object},
                              {"/scenario/values/judge", Type::object},
                              {"/scenario/values/judge/quantity", Type::string},
                              {"/scenario/values/view", Type::object},
                              {"/scenario/values/view/plots", Type::array, false, Type::string}};

bool is_right(const nlohmann::json& value, const Key& key) {
  return value.type() == key.type &&
         (key.elements == Type::null ||
          std::all_of(value.begin(), value.end(),
                      [&](const nlohmann::json& element) { return element.type() == key.elements; }));
}

void check_key(const nlohmann::json& about, const Key& key, const fs::path& file) {
  const nlohmann::json::json_pointer path(key.path);
  const bool there = about.is_object() && about.contains(path);
  if (there ? is_right(about.at(path), key) : !key.required) return;
  refuse_about(fmt::format("file '{}' is not one of a run: {} is {}", file.string(),
                           *key.path ? key.path + 1 : "the whole", there ? "of another type" : "missing"));
}

/// Names by `of`, as a part of `whole`; the largest first, at most `most`.
void add_largest(std::vector<std::string>& to, const nlohmann::json& all, const char* of, const char* whole,
                 std::size_t most) {
  constexpr double rounding = 1e-12;
  std::vector<std::pair<double, std::string>> parts;
  const auto number = [](const nlohmann::json& one, const char* key) {
    const auto it = one.find(key);
    return it != one.end() && it->is_number() ? it->get<double>() : 0.0;
  };
  for (const auto& [name, one] : all.items())
    if (const double size = std::abs(number(one, of)), peak = number(one, whole); size > rounding * peak)
      parts.emplace_back(size / peak, name);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t k = 0; k < std::min(most, parts.size()); ++k) to.push_back(parts[k].second);
}

bool is_damaged(const fs::path& json) try {
  output::read_json(json);
  return false;
} catch (const Error&) {
  return true;
}

}  // namespace

std::vector<std::string> largest_indicators(const nlohmann::json& about, const fs::path& folder) {
  std::vector<std::string> names;
  if (!about.contains("indicators") || !fs::is_regular_file(folder / "indicators.csv")) return names;
  const auto& all = about.at("indicators");
  const auto part = [&](const char* key) { return all.value(key, nlohmann::json::object()); };
  add_largest(names, part("defects"), "largest", "peak_of_input", 2);
  add_largest(names, part("energies"), "made", "passed", 1);
  add_largest(names, part("estimates"), "largest", "peak", 1);
  return names;
}

nlohmann::json read_about(const fs::path& folder) {
  const fs::path file = folder / "results.json";
  if (!fs::exists(file))
    refuse_about(fmt::format("file '{}' is missing; 'tandem run' writes it", file.string()));
  nlohmann::json about = output::read_json(file);
  for (const Key& key : about_keys) check_key(about, key, file);
  if (const nlohmann::json::json_pointer path("/scenario/values/subsystems"); about.contains(path))
    for (const nlohmann::json& subsystem : about.at(path))
      check_key(subsystem, {"/source", Type::string}, file);
  return about;
}

std::vector<std::string> files_of(const fs::path& folder) try {
  std::vector<std::string> names;
  if (!fs::exists(folder / "results.json")) return names;
  const nlohmann::json about = read_about(folder);
  for (const auto& file : about["files"]) names.push_back(file.get<std::string>());
  std::erase_if(names, [](const std::string& name) {  // the file may be a stranger's
    const std::string kind = fs::path(name).extension().string();
    const bool rows = name.starts_with("results.") && (kind == ".csv" || kind == ".npy");
    return !rows || fs::path(name).filename() != name;
  });
  return names;
} catch (const Error&) {
  return {};
}

std::string unfinished(const fs::path& place) try {
  const bool is_folder = fs::is_directory(place);
  const fs::path folder = is_folder ? place : fs::absolute(place).parent_path();
  if (!fs::exists(folder / "results.json")) return "";
  if (is_damaged(folder / "results.json"))
    return fmt::format("'{}' is beside a results.json that is damaged", place.string());
  const nlohmann::json about = read_about(folder);
  const auto& files = about["files"];
  if (!is_folder && std::find(files.begin(), files.end(), place.filename().string()) == files.end())
    return "";
  const std::string status = about.value("status", "it tells no status"),
                    message = about.value("message", "");
  if (status == "ok") return "";
  return fmt::format("'{}' is of a run that did not come to its end: {}{}{}", place.string(), status,
                     message.empty() ? "" : ", ", message);
} catch (const Error& error) {
  const bool is_of_run = fs::is_directory(place) || place.stem() == "results";
  return is_of_run ? fmt::format("'{}' is of no run: {}", place.string(), error.what()) : "";
}

text::TimeTable read_finished(const fs::path& place) {
  for (const fs::path& one : {place, fs::weakly_canonical(place), fs::weakly_canonical(place / "results.csv"),
                              fs::weakly_canonical(place / "results.npy")})  // there may be links
    if (const std::string what = unfinished(one); !what.empty())
      throw Error(ErrorCode::invalid_argument, what + "; allowed is one that is 'ok'");
  return text::TimeTable::read(place);
}

}  // namespace tandem::scenario
