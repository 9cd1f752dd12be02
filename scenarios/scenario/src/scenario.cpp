// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/scenario.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "tandem/transports/open.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem::scenario {
namespace {

bool in_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Where `name` stands in the sentence as a word of its own; npos if it does not.
std::size_t mention(const std::string& sentence, const std::string& name) {
  for (auto at = sentence.find(name); at != std::string::npos; at = sentence.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || !in_a_name(sentence[at - 1])) && (end == sentence.size() || !in_a_name(sentence[end])))
      return at;
  }
  return std::string::npos;
}
bool mentions(const std::string& sentence, const std::string& name) {
  return mention(sentence, name) != std::string::npos;
}

bool mentions_quoted(const std::string& sentence, const std::string& text) {
  return sentence.find("'" + text + "'") != std::string::npos;
}

}  // namespace

Place Scenario::place(const std::string& key) const {
  const auto it = places.find(key);
  return it != places.end() ? it->second : Place{file.string()};
}

Place Scenario::place_named_in(const std::string& sentence) const {
  const ConnectionEntry* best = nullptr;
  int best_ends = 0;
  for (const ConnectionEntry& c : connections) {
    const int ends = mentions(sentence, c.connection.from) + mentions(sentence, c.connection.to);
    if (ends > best_ends) best_ends = ends, best = &c;
  }
  if (best) return best->place_named_in(sentence);
  constexpr std::array keys{std::pair{"coordination.order", "coordination.order"},
                            std::pair{"communication_step", "coordination.communication_step"},
                            std::pair{"start from derivatives", "coordination.start"},
                            std::pair{"repeated start", "coordination.start"},
                            std::pair{"schedule", "coordination.schedule"},
                            std::pair{"span", "span.stop"}};
  for (const auto& [words, key] : keys)
    if (mentions(sentence, words)) return place(key);
  for (const SubsystemEntry& s : subsystems)
    for (const InputEntry& input : s.inputs)
      if (mentions(sentence, "input " + s.name + "." + input.port)) return input.place;
  for (const SubsystemEntry& s : subsystems)
    if (mentions(sentence, s.name)) return s.place;
  return {file.string()};
}

Place ConnectionEntry::place_named_in(const std::string& sentence) const {
  if (connection.how && mentions(sentence, connection.how->name())) return how_place;
  const bool unknown = sentence.find("is not there") != std::string::npos;
  const std::string reader = connection.to.substr(0, connection.to.find('.'));
  const bool at_reader = mentions(sentence, "input") || sentence.starts_with("subsystem '" + reader + "' is");
  if (unknown) return at_reader ? to_place : from_place;
  if (sentence.starts_with("port '")) return mentions_quoted(sentence, connection.to) ? to_place : from_place;
  for (const Place& end : {from_place, to_place, how_place})
    if (!end.set_by.empty()) return end;
  return place;
}

double InputEntry::at(double t) const {
  const double* number = std::get_if<double>(&value);
  return number ? *number : std::get<1>(value)->value(t);
}

std::string SubsystemEntry::address() const {
  return command.empty() ? source.substr(0, source.find('?')) : "command " + shown(command);
}

std::string SubsystemEntry::scheme() const { return SourceUri(source).scheme; }

std::filesystem::path SubsystemEntry::file() const {
  return std::filesystem::path(place.file).parent_path() / SourceUri(source).place;
}

/// That of the first parameter whose value the sentence tells ("index-3 formulation: beta is 0.3"), else of
/// the first that it names.
Place SubsystemEntry::place_named_in(const std::string& sentence) const {
  Place found = source_place;
  std::pair best(true, std::string::npos);  // told no value, where
  for (const Parameter& parameter : parameters) {
    const auto at = mention(sentence, parameter.name);
    if (at == std::string::npos) continue;
    const auto rest = std::string_view(sentence).substr(at + parameter.name.size());
    const bool told = rest.starts_with(" is ") || rest.starts_with("' is ");
    if (std::pair(!told, at) < best) best = {!told, at}, found = parameter.place;
  }
  return found;
}

bool by_impulse(const Scenario& scenario) {
  return std::any_of(scenario.subsystems.begin(), scenario.subsystems.end(),
                     [](const SubsystemEntry& one) { return one.impulse != nullptr; });
}

bool lacks_fast_period(const Scenario& scenario) {
  return by_impulse(scenario) && scenario.fast_period == 0.0;
}

}  // namespace tandem::scenario
