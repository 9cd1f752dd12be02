// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/view_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/mbs/mechanism/keys.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/section.hpp"

namespace tandem {
namespace {

using Kind = mbs::Entity::Kind;
using text::Section;

/// Reads the table with the names of one description.
class Reader {
 public:
  Reader(const mbs::Description& in, const text::Values& values) : in_(in), values_(values) {}

  ViewTable read(Section section) {
    ViewTable to;
    for (Section& wheel : section.sections("wheels")) {
      to.wheels.push_back(read_wheel(wheel));
      wheel.refuse_unknown();
    }
    to.ground = section.number("ground");
    if (const auto name = section.text("follow")) to.follow = entity(section, "follow", Kind::point, *name);
    for (const std::string& name : texts(section, "trace"))
      to.trace.push_back(entity(section, "trace", Kind::point, name));
    for (const std::string& name : texts(section, "plots"))
      to.plots.push_back(output(section, "plots", name));
    section.refuse_unknown();
    return to;
  }

 private:
  ViewTable::Wheel read_wheel(Section& section) {
    const std::string centre = section.required_text("centre");
    const double radius = section.required_number("radius"),
                 width = section.positive("width").value_or(0.5 * radius);
    ViewTable::Wheel wheel{entity(section, "centre", Kind::point, centre), {}, radius, width};
    if (in_.dimension == 2)
      section.leave_out("axis", "in the plane it is known");
    else if (!section.node("axis"))
      section.missing("axis");
    else
      wheel.axis = edge(section, "axis");
    if (section.node("spoke")) wheel.spoke = edge(section, "spoke");
    if (const auto name = section.text("angle")) wheel.angle = output(section, "angle", *name);
    if (wheel.spoke.to >= 0 && !wheel.angle.empty())
      section.wrong("angle", "'" + wheel.angle + "' beside a spoke", "one of them");
    return wheel;
  }

  /// "$NAME" among them is a word of the file's parameters.
  std::vector<std::string> texts(Section& section, const std::string& key) const {
    auto all = section.texts(key);
    for (std::string& text : all) {
      const text::FileValue* const value = text.starts_with("$") ? values_.find(text.substr(1)) : nullptr;
      if (value && std::holds_alternative<std::string>(*value)) text = std::get<std::string>(*value);
    }
    return all;
  }

  /// A vector's name, or two points.
  mbs::Edge edge(Section& section, const std::string& key) const {
    if (const toml::node* node = section.node(key); node->is_string())
      return {entity(section, key, Kind::vector, *section.text(key))};
    const auto names = texts(section, key);
    if (names.size() != 2) section.wrong(key, fmt::format("{} names", names.size()), edges);
    const mbs::Edge edge{entity(section, key, Kind::point, names[1]),
                         entity(section, key, Kind::point, names[0])};
    if (edge.to == edge.from) section.wrong(key, "'" + names[0] + "' twice", edges);
    return edge;
  }

  int entity(const Section& section, const std::string& key, Kind kind, const std::string& name) const {
    std::vector<std::string> known;
    for (std::size_t e = 0; e < in_.entities.size(); ++e) {
      if (in_.entities[e].kind != kind) continue;
      if (in_.entities[e].name == name) return static_cast<int>(e);
      known.push_back(in_.entities[e].name);
    }
    refuse(section, key, unknown(kind == Kind::point ? "point" : "vector", name, known));
  }

  std::string output(const Section& section, const std::string& key, const std::string& name) const {
    std::vector<std::string> known;
    for (const mbs::Output& output : in_.outputs) known.push_back(output.name);
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(section, key, unknown("output", name, known));
    return name;
  }

  [[noreturn]] static void refuse(const Section& section, const std::string& key,
                                  const std::string& sentence) {
    text::refuse(section.place(key), section.name(key) + ": " + sentence);
  }

  static constexpr const char* edges = "the name of a vector, or an array of two points";
  const mbs::Description& in_;
  const text::Values& values_;
};

}  // namespace

ViewTable read_view(const text::Document& document, const mbs::Description& description) {
  static const text::Keys language = mbs::mechanism_keys();
  text::Values values;
  for (const mbs::Parameter& p : description.parameters) values.set(p.name, p.value);
  auto section = Section(document, language, &values).section("view");
  return section ? Reader(description, values).read(std::move(*section)) : ViewTable{};
}

}  // namespace tandem
