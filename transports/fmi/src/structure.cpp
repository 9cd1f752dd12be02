// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "structure.hpp"

#include <limits>
#include <map>
#include <set>

#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

/// Reads of which variables others follow: in 2.0 by number, counted from 1; in 3.0 by reference.
class StructureReader {
 public:
  StructureReader(const Xml& xml, Description& d) : xml_(xml), d_(d) {
    if (d.version == Version::three)
      for (int k = 0; k < std::ssize(d.variables); ++k) places_.try_emplace(d.at(k).reference, k);
    else
      for (int k = 0; k < std::ssize(d.variables); ++k) places_.emplace(k + 1, k);
  }

  void read(pugi::xml_node structure) {
    const bool two = d_.version == Version::two;
    d_.outputs = two ? unknowns(structure.child("Outputs"), "Unknown") : unknowns(structure, "Output");
    d_.derivatives = two ? unknowns(structure.child("Derivatives"), "Unknown")
                         : unknowns(structure, "ContinuousStateDerivative");
    for (const Unknown& one : unknowns(structure, "EventIndicator")) d_.indicators.push_back(one.variable);
    for (const Unknown& state : d_.derivatives)
      if (const Variable& v = d_.at(state.variable); v.type != Type::float64 || v.derivative_of < 0)
        xml_.refuse(structure,
                    "variable '" + printable(v.name, 200) +
                        "' is listed as the derivative of a state; allowed is a real one that has the "
                        "attribute derivative");
  }

 private:
  std::vector<Unknown> unknowns(pugi::xml_node list, const char* element) const {
    std::vector<Unknown> all;
    std::set<int> seen;
    const char* const name = d_.version == Version::two ? "index" : "valueReference";
    for (const pugi::xml_node node : list.children(element)) {
      const auto of = xml_.list(node, "dependencies", 0, most());
      Unknown unknown{variable(node, name, xml_.whole(node, name, 0, most())), !of};
      if (!seen.insert(unknown.variable).second)
        xml_.refuse(node, "variable '" + printable(d_.at(unknown.variable).name, 200) + "' is listed twice");
      for (const std::int64_t one : of.value_or(std::vector<std::int64_t>()))
        unknown.of.push_back(variable(node, "dependencies", one));
      all.push_back(std::move(unknown));
    }
    return all;
  }

  static constexpr std::int64_t most() { return std::numeric_limits<std::uint32_t>::max(); }

  int variable(pugi::xml_node node, const char* attribute, std::optional<std::int64_t> number) const {
    const auto it = number ? places_.find(*number) : places_.end();
    if (it != places_.end()) return it->second;
    xml_.wrong(node, attribute,
               d_.version == Version::two
                   ? "the number of a variable, from 1 to " + std::to_string(places_.size())
                   : "the valueReference of a variable");
  }

  const Xml& xml_;
  Description& d_;
  std::map<std::int64_t, int> places_;
};

}  // namespace

void read_structure(const Xml& xml, pugi::xml_node structure, Description& d) {
  StructureReader(xml, d).read(structure);
}

}  // namespace tandem::fmi
