// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "reader.hpp"
#include "tandem/mbs/mechanism/motions.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/series.hpp"

namespace tandem::mbs {

void Reader::read_input(const std::string& name, Section& section) {
  port_name(section, name);
  Input input{name, section.required_text("unit")};
  if (input.unit.empty()) section.wrong("unit", "empty", "its unit, \"N\"; \"1\" for a ratio");
  if (const auto value = section.number("value")) input.value = *value;
  read_function(section, input);
  this->name(inputs_, section, name, to_.inputs.size());
  to_.inputs.push_back(std::move(input));
}

/// At most one of the keys that make it a function of time.
void Reader::read_function(Section& section, Input& input) const {
  int given = section.node("value") ? 1 : 0;
  if (auto c = numbers(section, "polynomial"); !c.empty()) {
    input.function = polynomial(std::move(c));
    ++given;
  }
  if (auto wave = section.section("sine")) {
    input.function = sine(sine_of(std::move(*wave)));
    ++given;
  }
  if (auto series = text::read_series(section, folder_)) {
    input.jumps.assign(series->jumps().begin(), series->jumps().end());
    input.smooth = input.jumps.empty() && series->kinks().empty();
    input.function = data(std::move(*series));
    ++given;
  }
  if (given > 1)
    text::refuse(section.place(),
                 fmt::format("input '{}' has {} of value, polynomial, sine and data; allowed is one",
                             input.name, given));
}

Sine Reader::sine_of(Section section) {
  const Sine read{section.required_number("amplitude"), section.required_number("frequency"),
                  *section.number("phase"), *section.number("mean")};
  section.refuse_unknown();
  return read;
}

void Reader::read_spring(const std::string& name, Section& section) {
  Spring spring;
  spring.name = name;
  only_one(section, "spring '" + name + "'", {"points", "coordinate"});
  const bool between = section.node("points") != nullptr;
  if (between) {
    spring.points = two_points(section, "points");
  } else {
    const Coordinate c = required_coordinate(section, "coordinate");
    if (c.relative < 0) section.wrong("coordinate", "one of a point", "an angle or a length");
    spring.relative = c.relative;
  }
  spring.stiffness = numbers(section, "stiffness");
  spring.damping = numbers(section, "damping");
  if (spring.stiffness.empty() && spring.damping.empty())
    section.missing("stiffness", "a number, or an array of one for each power; or damping");
  spring.free = section.number("free").value_or(between ? drawn(to_, spring.points).norm()
                                                        : drawn(to_, to_.relatives[spring.relative]));
  to_.springs.push_back(std::move(spring));
}

void Reader::read_force(const std::string& name, Section& section) {
  Force force{name, Force::Kind::relative};
  only_one(section, "force '" + name + "'", {"point", "between", "coordinate"});
  if (const auto on = section.text("point")) {
    force.kind = Force::Kind::point;
    force.index = point(section, "point", *on);
    if (to_.entities[force.index].fixed)
      section.wrong("point", "'" + *on + "', which is fixed", "a point that is not");
    force.direction = required_vector(section, "direction");
    if (!(force.direction.norm() > 0.0)) section.wrong("direction", "zero", "a direction");
  } else if (section.leave_out("direction", "the force is on no point"); section.node("between")) {
    force.kind = Force::Kind::line;
    force.points = two_points(section, "between");
    if (to_.entities[force.points.to].fixed && to_.entities[force.points.from].fixed)
      section.wrong("between", "two fixed points", "two points of which one is not");
  } else {
    const Coordinate c = required_coordinate(section, "coordinate");
    if (c.relative < 0) section.wrong("coordinate", "one of a point", "an angle or a length");
    force.index = c.relative;
  }
  force.input = magnitude(section, name);
  const bool torque = force.kind == Force::Kind::relative && is_angle(to_, {-1, 0, force.index});
  if (const auto gain = section.number("gain"))
    force.gain = *gain;
  else if (!values_.is_number(*section.node("magnitude")))
    unit(section, "magnitude", force.input, {torque ? "N m" : "N"});
  to_.forces.push_back(force);
}

void Reader::unit(Section& section, const std::string& key, int input,
                  const std::vector<std::string>& allowed) const {
  const Input& i = to_.inputs[input];
  if (std::find(allowed.begin(), allowed.end(), i.unit) == allowed.end())
    section.wrong(key, "'" + i.name + "' in " + i.unit, "an input in " + listed(allowed));
}

void Reader::refuse_unused_inputs(Section& root) const {
  const auto used = [&](int input) {
    const auto uses = [input](const auto& element) { return element.input == input; };
    const auto acts_by = [input](const NamedElement& e) {
      const auto& inputs = e.force->inputs();
      return std::find(inputs.begin(), inputs.end(), input) != inputs.end();
    };
    return std::any_of(to_.forces.begin(), to_.forces.end(), uses) ||
           std::any_of(to_.elements.begin(), to_.elements.end(), acts_by) ||
           std::any_of(to_.drives.begin(), to_.drives.end(), uses);
  };
  for (const auto& [name, index] : inputs_)
    if (!used(index))
      text::refuse(document_.place(*root.table("inputs")->get(name)),
                   "input '" + name + "' is used by no force, drive or element; allowed is one that is");
}

int Reader::magnitude(Section& section, const std::string& name) {
  const toml::node* node = section.node("magnitude");
  if (!node) section.missing("magnitude");
  if (node->is_string() && !values_.is_number(*node))
    return find(inputs_, section, "magnitude", "input", *section.text("magnitude"));
  Input constant{name, ""};
  constant.value = values_.number(document_, *node, section.name("magnitude"));
  constant.function = polynomial({constant.value});
  to_.inputs.push_back(std::move(constant));
  return static_cast<int>(to_.inputs.size()) - 1;
}

}  // namespace tandem::mbs
