// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "reader.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

constexpr const char* ends_of_places = "two points are the ends";

/// What has a meaning in the plane.
bool is_planar(Joint::Kind kind) {
  return kind == Joint::Kind::revolute || kind == Joint::Kind::prismatic ||
         kind == Joint::Kind::point_on_line;
}

}  // namespace

void Reader::read_distance(const std::string& name, Section& section) {
  only_one(section, "distance '" + name + "'", {"points", "between"});
  if (section.node("between")) {
    section.leave_out("length", "a distance of places is as drawn");
    to_.links.push_back({name, ends(section), section.place().text()});
    return;
  }
  section.leave_out("ends", ends_of_places);
  const Edge edge = two_points(section, "points");
  const double l = section.positive("length").value_or(drawn(to_, edge).norm());
  if (!can_be_squared(l)) section.wrong("length", fmt::format("{} m", l), "1e-100 to 1e100 m");
  to_.products.push_back({name, edge, edge, l * l, section.place().text(), "distance"});
}

void Reader::read_product(const std::string& name, Section& section) {
  const auto [a, b] = two_edges(section, "edges");
  const double value = section.number("value").value_or(drawn(to_, a).dot(drawn(to_, b)));
  const bool back = a.from >= 0 && a.from == b.to && a.to == b.from;
  if ((a == b && !(value > 0.0)) || (back && !(value < 0.0)))
    section.wrong("value", fmt::format("{} m^2 of an edge with itself{}", value, back ? " turned round" : ""),
                  back ? "a number below 0" : "a number above 0");
  to_.products.push_back({name, a, b, value, section.place().text()});
}

void Reader::read_fixed_angle(const std::string& name, Section& section) {
  const auto [a, b] = two_edges(section, "edges");
  to_.fixed_angles.push_back({name, a, b, section.place().text()});
}

void Reader::read_joint(const std::string& name, Section& section) {
  Joint joint{name, Joint::Kind::revolute, {}, {}};
  joint.where = section.place().text();
  const std::string word = section.kind();
  const auto& words = language_.find("joints.NAME.kind")->words;  // in the order of the kinds
  joint.kind = static_cast<Joint::Kind>(std::find(words.begin(), words.end(), word) - words.begin());
  if (to_.dimension == 2 && !is_planar(joint.kind))
    section.wrong("kind", "'" + word + "'", "revolute, prismatic or point_on_line in the plane");
  const auto between = section.texts("between");
  if (between.size() != 2)
    section.wrong("between", fmt::format("{} names", between.size()),
                  "two names, each of a body, of a point, or \"ground\"");
  joint.first = carrier(section, between[0]);
  joint.second = carrier(section, between[1]);
  joint.at = required_vector(section, "at");
  read_axes(section, joint);
  to_.joints.push_back(joint);
}

void Reader::read_axes(Section& section, Joint& joint) const {
  using enum Joint::Kind;
  if (joint.kind == spherical) return;
  if (joint.kind == revolute && to_.dimension == 2) return section.leave_out("axis", "in the plane");
  joint.axes[0] = required_vector(section, "axis");
  if (joint.kind == universal) joint.axes[1] = required_vector(section, "second_axis");
}

Carrier Reader::carrier(Section& section, const std::string& name) const {
  if (name == "ground") return {};
  if (const auto it = bodies_.find(name); it != bodies_.end()) return {Carrier::Kind::body, it->second};
  if (const auto it = entities_.find(name); it != entities_.end())
    return {Carrier::Kind::point, point(section, "between", name)};
  std::vector<std::string> known = {"ground"};
  for (const auto& [body, index] : bodies_) known.push_back(body);
  text::refuse(section.place("between"), section.name("between") + ": " + unknown("body", name, known));
}

void Reader::read_angle(const std::string& name, Section& section) {
  Relative angle{name, Relative::Kind::angle};
  angle.a = edge(section, "from", section.node("from"));
  angle.b = edge(section, "to", section.node("to"));
  angle.where = section.place().text();
  if (to_.dimension == 3)
    angle.axis = vector_named(section, "axis", section.required_text("axis"), "the name of a vector");
  else
    section.leave_out("axis", "in the plane all turn about one");
  relative_name(section, name);
  to_.relatives.push_back(angle);
}

void Reader::read_length(const std::string& name, Section& section) {
  only_one(section, "length '" + name + "'", {"points", "between"});
  Relative length{name, Relative::Kind::length};
  length.where = section.place().text();
  if (section.node("points")) {
    section.leave_out("ends", ends_of_places);
    length.a = two_points(section, "points");
  } else {
    length.ends = ends(section);
  }
  relative_name(section, name);
  to_.relatives.push_back(std::move(length));
}

void Reader::read_drive(const std::string& name, Section& section) {
  Drive drive{name, required_coordinate(section, "coordinate"), -1, section.place().text()};
  if (drive.coordinate.entity >= 0 && to_.entities[drive.coordinate.entity].fixed)
    section.wrong("coordinate", "of a fixed point", "one that is not fixed");
  drive.input = find(inputs_, section, "motion", "input", section.required_text("motion"));
  const Coordinate& c = drive.coordinate;
  const bool vector = c.entity >= 0 && to_.entities[c.entity].kind == Entity::Kind::vector;
  unit(section, "motion", drive.input,
       is_angle(to_, c) ? std::vector<std::string>{"rad"}
       : vector         ? std::vector<std::string>{"1", "m"}
                        : std::vector<std::string>{"m"});
  if (const Input& motion = to_.inputs[drive.input]; !motion.smooth)
    section.wrong("motion", "'" + motion.name + "', data that jump or bend, where there is no acceleration",
                  "a function with one: data with interpolation = \"spline\" and without an end in the run, "
                  "a polynomial "
                  "or a sine, or a port");
  this->name(drives_, section, name, to_.drives.size());
  to_.drives.push_back(drive);
}

}  // namespace tandem::mbs
