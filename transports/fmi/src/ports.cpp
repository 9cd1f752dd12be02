// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ports.hpp"

#include <algorithm>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

constexpr int most_derivatives = 3;

class PortMaker {
 public:
  PortMaker(const Description& d, const Settings& s) : d_(d), s_(s), input_of_(d.variables.size(), -1) {
    for (int k = 0; k < std::ssize(d.variables); ++k)
      if (const int of = at(k).derivative_of; of >= 0) derivative_of_.try_emplace(number_of(of), k);
    for (const auto* list : {&d.outputs, &d.derivatives})
      for (const Unknown& u : *list) structure_of_.try_emplace(number_of(u.variable), &u);
  }

  Ports make() {
    ports_.info.name = d_.name;
    for (int k = 0; k < std::ssize(d_.variables); ++k)
      if (at(k).type != Type::string) add(k);
    if (outputs_.empty())
      throw Error(
          ErrorCode::invalid_argument,
          "the FMU '" + printable(d_.name, 200) + "' has no output that is a number; allowed is one or more");
    check_units();
    add_derivatives();
    for (const auto& [variable, place] : ports_.row) add_follows(variable, place);
    find_followed();
    set_abilities();
    return std::move(ports_);
  }

 private:
  const Variable& at(int k) const { return d_.variables[static_cast<std::size_t>(k)]; }
  static bool is_continuous(const Variable& v) {
    return v.type == Type::real && v.variability == Variability::continuous;
  }

  void add(int k) {
    const Variable& v = at(k);
    const bool input = v.causality == Causality::input;
    if (!input && v.causality != Causality::output) return;
    Port port{port_name(v.name), v.unit};
    if (const auto it = s_.units.find(v.name); it != s_.units.end()) port.unit = it->second;
    if (input) return add_input(k, std::move(port));
    port.held = !is_continuous(v);
    port.nominal = v.nominal;
    ports_.row.push_back({k, static_cast<int>(outputs_.size())});
    outputs_.push_back(k);
    ports_.info.outputs.push_back(std::move(port));
  }

  void add_input(int k, Port port) {
    const int place = static_cast<int>(ports_.info.inputs.size());
    input_of_[static_cast<std::size_t>(k)] = place;
    port.start = at(k).start_value;
    ports_.info.inputs.push_back(std::move(port));
    (is_continuous(at(k)) ? ports_.continuous : ports_.discrete).push_back({k, place});
  }

  void check_units() const {
    std::vector<std::string> names;
    for (const Variable& v : d_.variables)
      if (v.causality == Causality::input || v.causality == Causality::output) names.push_back(v.name);
    for (const auto& [name, unit] : s_.units)
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw Error(ErrorCode::invalid_argument,
                    unknown("parameter unit: port", printable(name, 200), names));
  }

  /// Variables of one type and reference are one number.
  using Number = std::pair<bool, std::uint32_t>;
  Number number_of(int variable) const { return {at(variable).type == Type::real, at(variable).reference}; }

  /// -1 if there is none.
  int derivative_of(int variable) const {
    const auto it = derivative_of_.find(number_of(variable));
    return it == derivative_of_.end() ? -1 : it->second;
  }
  /// Null: nothing is said of it.
  const Unknown* structure_of(int variable) const {
    const auto it = structure_of_.find(number_of(variable));
    return it == structure_of_.end() ? nullptr : it->second;
  }

  void add_derivatives() {
    const auto outputs = static_cast<int>(outputs_.size());
    for (int k = 0; k < outputs; ++k) {
      Port& port = ports_.info.outputs[static_cast<std::size_t>(k)];
      int variable = outputs_[static_cast<std::size_t>(k)];
      if (!is_continuous(at(variable))) continue;
      while (port.derivatives < most_derivatives && (variable = derivative_of(variable)) >= 0 &&
             is_known(variable))
        ports_.row.push_back({variable, ++port.derivatives * outputs + k});
    }
  }

  /// After a step of Co-Simulation a derivative that follows an input at once is that of the input over the
  /// step.
  bool is_known(int variable) const {
    if (s_.kind == Kind::model_exchange) return true;
    const Unknown* u = structure_of(variable);
    return u && !u->of_all && std::all_of(u->of.begin(), u->of.end(), [this](int one) {
             return at(one).causality != Causality::input;
           });
  }

  void add_follows(int variable, int place) {
    const Unknown* u = structure_of(variable);
    const auto add = [&](int input) {
      ports_.follows.push_back({place, input});
      if (place < static_cast<int>(outputs_.size())) ports_.info.feedthrough.push_back({place, input});
    };
    if (u && !u->of_all) {
      for (const int one : u->of)
        if (const int input = input_of_[static_cast<std::size_t>(one)]; input >= 0) add(input);
    } else {
      for (int input = 0; input < std::ssize(ports_.info.inputs); ++input) add(input);
    }
  }

  void find_followed() {
    for (const Seat& seat : ports_.continuous)
      if (std::any_of(ports_.info.feedthrough.begin(), ports_.info.feedthrough.end(),
                      [&](const Feedthrough& f) { return f.input == seat.place; }))
        ports_.followed.push_back(seat);
  }

  void set_abilities() {
    const bool exchange = s_.kind == Kind::model_exchange;
    const Offer& offer = offer_of(d_, s_.kind);
    Abilities& a = ports_.info.abilities;
    a.restarts = true;
    a.lands = exchange || s_.lands;
    a.events = exchange;
    a.saves_state = offer.keeps_state && (exchange || s_.trusts_state);
    a.serializes_state = a.saves_state && offer.serializes_state;
  }

  const Description& d_;
  const Settings& s_;
  std::vector<int> input_of_, outputs_;
  std::map<Number, int> derivative_of_;
  std::map<Number, const Unknown*> structure_of_;
  Ports ports_;
};

}  // namespace

Ports ports_of(const Description& description, const Settings& settings) {
  return PortMaker(description, settings).make();
}

std::string port_name(const std::string& variable) {
  std::string name = variable;
  for (char& c : name) switch (c) {
      case '[':
        c = '(';
        break;
      case ']':
        c = ')';
        break;
      case ',':
        c = ';';
        break;
      case '"':
        c = '\'';
        break;
      case ' ':
      case '\t':
      case '\n':
        c = '_';
        break;
      default:
        break;
    }
  return name;
}

}  // namespace tandem::fmi
