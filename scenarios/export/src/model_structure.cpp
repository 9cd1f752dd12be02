// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "model_structure.hpp"

#include <algorithm>

namespace tandem::exported {
namespace {

using Kind = Variable::Kind;
using pugi::xml_node;
using Places = std::vector<std::size_t>;

class Structure {
 public:
  Structure(const Unit& unit, bool two) : unit_(unit), two_(two), inputs_(of_kinds(unit, {Kind::input})) {
    for (const std::size_t k : of_kinds(unit, {Kind::rate})) rates_.push_back(k);
    std::sort(rates_.begin(), rates_.end(),
              [&](auto a, auto b) { return unit.variables()[a].index < unit.variables()[b].index; });
  }

  void write(xml_node to) const {
    const bool exchange = unit_.manifest().interface == Interface::model_exchange;
    for (const std::size_t k : of_kinds(unit_, {Kind::output})) {
      xml_node one = unknown(to, "Outputs", "Output", k);
      one.append_attribute("dependencies").set_value(dependencies(k, exchange).c_str());
    }
    for (const std::size_t k : exchange ? rates_ : of_kinds(unit_, {Kind::derivative}))
      unknown(to, "Derivatives", "ContinuousStateDerivative", k);
    for (const std::size_t k : of_kinds(unit_, {Kind::output, Kind::derivative, Kind::state, Kind::rate}))
      unknown(to, "InitialUnknowns", "InitialUnknown", k);
    if (!two_)
      for (const std::size_t k : of_kinds(unit_, {Kind::indicator})) unknown(to, "", "EventIndicator", k);
  }

 private:
  /// Of 2.0 the unknowns of a kind stand in a list, of 3.0 each in its own element.
  xml_node unknown(xml_node to, const char* list, const char* element, std::size_t k) const {
    xml_node in = to;
    if (two_ && !(in = to.child(list))) in = to.append_child(list);
    xml_node one = in.append_child(two_ ? "Unknown" : element);
    const char* attribute = two_ ? "index" : "valueReference";
    one.append_attribute(attribute).set_value(reference_of(k, two_).c_str());
    return one;
  }

  /// In Model Exchange also states, each of which stands before its rate, and time are known.
  std::string dependencies(std::size_t output, bool exchange) const {
    std::string list;
    const auto add = [&](std::size_t k) { list += (list.empty() ? "" : " ") + reference_of(k, two_); };
    for (const Feedthrough& f : unit_.info().feedthrough)
      if (f.output == unit_.variables()[output].index) add(inputs_[static_cast<std::size_t>(f.input)]);
    for (const std::size_t rate : rates_) add(rate - 1);
    if (exchange) add(0);
    return list;
  }

  const Unit& unit_;
  bool two_;
  Places inputs_, rates_;  ///< rates in the order of the states
};

}  // namespace

std::vector<std::size_t> of_kinds(const Unit& unit, const std::vector<Kind>& kinds) {
  Places all;
  for (std::size_t k = 0; k < unit.variables().size(); ++k)
    if (std::find(kinds.begin(), kinds.end(), unit.variables()[k].kind) != kinds.end()) all.push_back(k);
  return all;
}

void write_structure(xml_node to, const Unit& unit, bool two) { Structure(unit, two).write(to); }

}  // namespace tandem::exported
