// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "reader.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

using Kind = Output::Kind;
constexpr std::pair<const char*, Kind> motions[] = {
    {"position", Kind::position}, {"velocity", Kind::velocity}, {"acceleration", Kind::acceleration}};
constexpr std::pair<const char*, Kind> energy_words[] = {{"kinetic", Kind::kinetic},
                                                         {"potential", Kind::potential},
                                                         {"total", Kind::energy},
                                                         {"drift", Kind::drift}};
constexpr std::pair<const char*, Kind> angles[] = {{"elevation", Kind::elevation},
                                                   {"heading", Kind::heading}};
constexpr std::pair<const char*, Kind> residual_words[] = {{"position", Kind::position_residual},
                                                           {"velocity", Kind::velocity_residual},
                                                           {"acceleration", Kind::acceleration_residual}};

/// What the key means, if it is there.
template <std::size_t N>
bool read_word(text::Section& section, const std::string& key, const std::pair<const char*, Kind> (&words)[N],
               Kind& kind) {
  const auto word = section.text(key);
  for (const auto& [name, meant] : words)
    if (word == name) return kind = meant, true;
  return false;
}

}  // namespace

/// Exactly one of the keys position, velocity, acceleration, reaction, energy, residual, elevation, heading,
/// element and accelerance.
void Reader::read_output(const std::string& name, Section& section) {
  port_name(section, name);
  Output output{name, Kind::position};
  int given = 0;
  for (const auto& [key, kind] : motions)
    if (section.node(key)) {
      output.kind = kind;
      output.coordinate = required_coordinate(section, key);
      ++given;
    }
  if (const auto of = section.text("reaction")) {
    read_reaction(section, *of, output);
    ++given;
  } else {
    section.leave_out("body", "it is no reaction");
  }
  given += read_word(section, "energy", energy_words, output.kind);
  given += read_word(section, "residual", residual_words, output.kind);
  for (const auto& [key, kind] : angles)
    if (section.node(key)) {
      output.kind = kind;
      output.edge = edge(section, key, section.node(key));
      ++given;
    }
  if (const auto element = section.text("element")) {
    read_element_quantity(section, *element, output);
    ++given;
  } else {
    section.leave_out("quantity", "it is of no element");
  }
  if (section.node("accelerance")) {
    read_accelerance(section, output);
    ++given;
  } else {
    section.leave_out("input", "it is no accelerance");
  }
  output.gain = *section.number("gain");
  if (given != 1)
    text::refuse(
        section.place(),
        fmt::format("output '{}' names {} quantities; allowed is one of position, velocity, "
                    "acceleration, reaction, energy, residual, elevation, heading, element and accelerance",
                    name, given));
  check_column(section, output);
  to_.outputs.push_back(output);
}

/// Where points are recorded, "P.x" is the column of that coordinate of a point or vector.
void Reader::check_column(const Section& section, const Output& output) const {
  const auto dot = output.name.rfind('.');
  const auto it = dot == std::string::npos ? entities_.end() : entities_.find(output.name.substr(0, dot));
  if (it == entities_.end()) return;
  const std::string axis = output.name.substr(dot + 1);
  const auto number = std::string("xyz").substr(0, static_cast<std::size_t>(to_.dimension)).find(axis);
  if (axis.size() != 1 || number == std::string::npos) return;
  const Coordinate own{it->second, static_cast<int>(number)};
  if (output.kind != Kind::position || !(output.coordinate == own))
    text::refuse(section.place(), "output '" + output.name +
                                      "' is not the position that is called so where "
                                      "points are recorded; allowed is another name");
}

void Reader::read_element_quantity(Section& section, const std::string& element, Output& output) const {
  output.kind = Kind::quantity;
  output.element = find(elements_, section, "element", "element", element);
  const auto all = to_.elements[static_cast<std::size_t>(output.element)].force->quantities();
  const std::string name = section.required_text("quantity", "one of the element's quantities");
  std::vector<std::string> known;
  for (const auto& quantity : all) known.push_back(quantity.name);
  const auto at = std::find(known.begin(), known.end(), name);
  if (at == known.end())
    text::refuse(section.place("quantity"),
                 section.name("quantity") + ": " + unknown("quantity", name, known));
  output.quantity = static_cast<int>(at - known.begin());
}

void Reader::read_accelerance(Section& section, Output& output) const {
  output.kind = Kind::accelerance;
  output.coordinate = required_coordinate(section, "accelerance");
  const std::string name = section.required_text("input", "an input that a force follows");
  output.input = find(inputs_, section, "input", "input", name);
  if (!only_forces_follow(to_, output.input))
    section.wrong("input", "'" + name + "', which is not of forces alone",
                  "an input that only forces follow");
}

/// Of a drive, of a fixed point along an axis, or on a body at one of its points.
void Reader::read_reaction(Section& section, const std::string& of, Output& output) const {
  if (const auto it = drives_.find(of); it != drives_.end()) {
    section.leave_out("body", "it is the reaction of a drive");
    output.kind = Kind::drive_reaction;
    output.drive = it->second;
    return;
  }
  output.kind = Kind::reaction;
  if (of.rfind('.') == std::string::npos) find(drives_, section, "reaction", "drive", of);
  output.coordinate = coordinate(section, "reaction", of);
  if (const auto body = section.text("body")) return read_body_of_reaction(section, *body, output);
  if (!to_.entities[output.coordinate.entity].fixed)
    section.wrong(
        "reaction", "'" + of + "', a point that is not fixed",
        "a drive, or a fixed point's axis; of another point the body that the reaction is on, body = NAME");
}

void Reader::read_body_of_reaction(Section& section, const std::string& name, Output& output) const {
  output.body = find(bodies_, section, "body", "body", name);
  const Body& body = to_.bodies[static_cast<std::size_t>(output.body)];
  if (output.coordinate.entity < 0 ||
      std::find(body.entities.begin(), body.entities.end(), output.coordinate.entity) == body.entities.end())
    section.wrong("reaction", "of no point or vector of body '" + name + "'", "one of those that it names");
}

void Reader::read_initial(Section& root) {
  auto initial = root.section("initial");
  if (!initial) return;
  read_given(*initial, "positions", to_.positions);
  read_given(*initial, "velocities", to_.velocities);
  to_.equilibrium = *initial->flag("equilibrium");
  initial->refuse_unknown();
}

/// Replaces what is known of a coordinate already.
void Reader::read_given(Section& initial, const std::string& key, std::vector<Given>& to) {
  const toml::table* table = initial.table(key);
  if (!table) return;
  for (const auto& [name, node] : text::in_file_order(*table)) {
    const Coordinate c = coordinate(initial, key, name);
    if (c.entity >= 0 && to_.entities[c.entity].fixed)
      initial.wrong(key, "'" + name + "', of a fixed point", "coordinates that are not fixed");
    std::erase_if(to, [&](const Given& g) { return g.coordinate == c; });
    to.push_back(
        {c, values_.number(document_, *node, initial.name(key) + "." + name), document_.place(*node).text()});
  }
}

}  // namespace tandem::mbs
