// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ports.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

constexpr int most_derivatives = 3;
constexpr std::size_t most_pairs = std::size_t{1} << 24;

class PortMaker {
 public:
  PortMaker(const Description& d, const Settings& s) : d_(d), s_(s), input_of_(d.variables.size()) {
    for (int k = 0; k < std::ssize(d.variables); ++k)
      if (const int of = at(k).derivative_of; of >= 0) derivative_of_.try_emplace(number_of(of), k);
    for (const auto* list : {&d.outputs, &d.derivatives})
      for (const Unknown& u : *list) structure_of_.try_emplace(number_of(u.variable), &u);
  }

  Ports make() {
    ports_.info.name = d_.name;
    for (int k = 0; k < std::ssize(d_.variables); ++k)
      if (is_number(at(k).type) && at(k).size > 0 && !at(k).clocked) add(k);
    if (outputs_.empty())
      throw Error(
          ErrorCode::invalid_argument,
          "the FMU '" + printable(d_.name, 200) + "' has no output that is a number; allowed is one or more");
    check_units();
    add_derivatives();
    for (const Seat& seat : ports_.row) add_follows(seat);
    find_followed();
    set_abilities();
    return std::move(ports_);
  }

 private:
  const Variable& at(int k) const { return d_.at(k); }
  static bool is_continuous(const Variable& v) {
    return is_real(v.type) && v.variability == Variability::continuous;
  }

  void add(int k) {
    const Variable& v = at(k);
    const bool input = v.causality == Causality::input;
    const bool wanted = std::find(s_.outputs.begin(), s_.outputs.end(), v.name) != s_.outputs.end();
    if (!input && v.causality != Causality::output && !wanted) return;
    Port port{port_name(v.name), v.unit, v.size};
    if (const auto it = s_.units.find(v.name); it != s_.units.end()) port.unit = it->second;
    if (input) return add_input(k, std::move(port));
    port.held = !is_continuous(v);
    port.nominal = v.nominal;
    ports_.row.push_back({k, output_size_, v.size});
    output_size_ += v.size;
    outputs_.push_back(k);
    ports_.info.outputs.push_back(std::move(port));
  }

  void add_input(int k, Port port) {
    const Variable& v = at(k);
    const Seat seat{k, input_size_, v.size};
    input_size_ += v.size;
    input_of_[static_cast<std::size_t>(k)] = seat;
    inputs_.push_back(seat);
    put_start(v.size, start_of(k), port);
    ports_.info.inputs.push_back(std::move(port));
    (is_continuous(v) ? ports_.continuous : ports_.discrete).push_back(seat);
    if (is_continuous(v) && v.intermediate) ports_.asked.push_back(seat);
  }

  /// As it is set, else as the FMU says.
  const std::vector<double>& start_of(int k) const {
    for (const Setting& one : s_.values)
      if (one.variable == k) return one.numbers;
    return at(k).start_values;
  }

  /// One number is that of all.
  static void put_start(int size, const std::vector<double>& start, Port& port) {
    if (start.empty() || (start.size() > 1 && std::ssize(start) != size)) return;
    const bool same = std::equal(start.begin() + 1, start.end(), start.begin());
    same ? void(port.start = start[0]) : void(port.starts = start);
  }

  void check_units() const {
    std::vector<std::string> names;
    for (const Variable& v : d_.variables)
      if (v.causality == Causality::input || v.causality == Causality::output) names.push_back(v.name);
    names.insert(names.end(), s_.outputs.begin(), s_.outputs.end());
    for (const auto& [name, unit] : s_.units)
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw Error(ErrorCode::invalid_argument,
                    unknown("parameter unit: port", printable(name, 200), names));
  }

  /// Variables of one type and reference are one number.
  using Number = std::pair<int, std::uint32_t>;
  Number number_of(int variable) const {
    const Type type = at(variable).type;
    return {is_real(type) ? 0 : type == Type::boolean ? 1 : 2, at(variable).reference};
  }

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
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      Port& port = ports_.info.outputs[k];
      const Seat values = ports_.row[k];
      int variable = outputs_[k];
      if (!is_continuous(at(variable))) continue;
      while (port.derivatives < most_derivatives && (variable = derivative_of(variable)) >= 0 &&
             is_known(variable) && at(variable).size == values.size)
        ports_.row.push_back({variable, ++port.derivatives * output_size_ + values.place, values.size});
      if (!s_.derives_outputs || port.derivatives > 0) continue;
      port.derivatives = 1;
      ports_.derived.push_back({outputs_[k], output_size_ + values.place, values.size});
    }
  }

  /// After a step of Co-Simulation a derivative that follows an input at once is that of what the FMU takes
  /// the input for at the step's end.
  bool is_known(int variable) const {
    if (s_.kind == Kind::model_exchange) return true;
    const Unknown* u = structure_of(variable);
    if (u && s_.held == Held::derivatives) return true;
    return u && !u->of_all && std::all_of(u->of.begin(), u->of.end(), [this](int one) {
             return at(one).causality != Causality::input;
           });
  }

  /// A state follows no input at once.
  bool is_state(int variable) const {
    const int rate = derivative_of(variable);
    return rate >= 0 && std::any_of(d_.derivatives.begin(), d_.derivatives.end(), [&](const Unknown& u) {
             return number_of(u.variable) == number_of(rate);
           });
  }

  /// Each of an array follows each of another.
  void add_follows(const Seat& seat) {
    const Unknown* u = structure_of(seat.variable);
    if (!u && is_state(seat.variable)) return;
    const auto add = [&](const Seat& input) {
      if (ports_.follows.size() + std::size_t(seat.size) * std::size_t(input.size) > most_pairs)
        throw Error(ErrorCode::invalid_argument,
                    "the FMU '" + printable(d_.name, 200) + "' has more than " + std::to_string(most_pairs) +
                        " pairs of an output and an input that it follows at once");
      for (int place = seat.place; place < seat.end(); ++place)
        for (int k = input.place; k < input.end(); ++k) {
          ports_.follows.push_back({place, k});
          if (place < output_size_) ports_.info.feedthrough.push_back({place, k});
        }
    };
    if (u && !u->of_all) {
      for (const int one : u->of)
        if (const auto& input = input_of_[static_cast<std::size_t>(one)]) add(*input);
    } else {
      for (const Seat& input : inputs_) add(input);
    }
  }

  void find_followed() {
    std::vector<char> followed(static_cast<std::size_t>(input_size_));
    for (const Feedthrough& f : ports_.info.feedthrough) followed[static_cast<std::size_t>(f.input)] = 1;
    for (const Seat& seat : ports_.continuous)  // all of an array, or none
      if (followed[static_cast<std::size_t>(seat.place)]) ports_.followed.push_back(seat);
  }

  void set_abilities() {
    const bool exchange = s_.kind == Kind::model_exchange;
    const Offer& offer = offer_of(d_, s_.kind);
    Abilities& a = ports_.info.abilities;
    a.restarts = true;
    a.lands = exchange || s_.lands;
    a.events = exchange || offer.has_events;
    const bool keeps_past = s_.integrator && d_.state_size() > 0;
    a.saves_state = offer.keeps_state && (exchange ? !keeps_past : s_.trusts_state);
    a.serializes_state = a.saves_state && offer.serializes_state;
  }

  const Description& d_;
  const Settings& s_;
  std::vector<std::optional<Seat>> input_of_;  ///< by variable
  std::vector<Seat> inputs_;
  std::vector<int> outputs_;
  int input_size_ = 0, output_size_ = 0;
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
