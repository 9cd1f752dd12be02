// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/variables.hpp"

#include <set>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::exported {
namespace {

using Kind = Variable::Kind;

constexpr std::size_t longest_shown = 200;

/// Variables whose names are distinct.
class List {
 public:
  explicit List(const std::string& owner) : owner_(owner) { add({"time", Kind::time, "s"}); }

  void add(Variable v, const std::string& otherwise = "") {
    for (const std::string& text : {v.name, v.word})
      if (printable(text, std::string::npos) != text)
        throw Error(ErrorCode::invalid_argument, "'" + owner_ + "' has '" + printable(text, longest_shown) +
                                                     "', a text that the description of an FMU can't have");
    if (!names_.insert(v.name).second) {
      v.name = otherwise + v.name;
      if (otherwise.empty() || !names_.insert(v.name).second)
        throw Error(ErrorCode::invalid_argument,
                    "'" + owner_ + "' has several ports or parameters that an FMU would call '" + v.name +
                        "'; allowed are names of their own");
    }
    all_.push_back(std::move(v));
  }
  const Variable& newest() const { return all_.back(); }
  std::vector<Variable> take() { return std::move(all_); }

 private:
  const std::string& owner_;
  std::vector<Variable> all_;
  std::set<std::string> names_;
};

void add_inputs(const SubsystemInfo& info, const std::vector<double>& start, List& to) {
  for (int k = 0; k < info.input_size(); ++k) {
    const Scalar scalar = scalar_at(info.inputs, k);
    Variable v{scalar.name(), Kind::input, scalar.port->unit, k};
    v.start = start[static_cast<std::size_t>(k)];
    to.add(std::move(v), "input.");
  }
}

void add_outputs(const SubsystemInfo& info, List& to) {
  for (int k = 0; k < info.output_size(); ++k) {
    const Scalar scalar = scalar_at(info.outputs, k);
    const Port& port = *scalar.port;
    to.add({scalar.name(), Kind::output, port.unit, k, port.derivatives, port.held}, "output.");
    for (int order = 1; order <= port.derivatives; ++order)
      to.add({"der(" + to.newest().name + ")", Kind::derivative, "", k, order});
  }
}

void add_state(Variable v, int state, const ExchangedStates& all, const std::string& otherwise, List& to) {
  v.reset = all.reset[static_cast<std::size_t>(state)] != 0;
  to.add(std::move(v), otherwise);
  to.add({"der(" + to.newest().name + ")", Kind::rate, "", state});
}

/// States that no output stands for are local: "state.NAME".
void add_exchanged(const SubsystemInfo& info, const ExchangedStates& states, List& to) {
  std::vector<char> shown(states.names.size());
  for (int k = 0; k < info.output_size(); ++k) {
    const Scalar scalar = scalar_at(info.outputs, k);
    const int state = states.of_outputs[static_cast<std::size_t>(k)];
    const Variable output{scalar.name(), Kind::output, scalar.port->unit, k, state >= 0, scalar.port->held};
    if (state < 0) {
      to.add(output, "output.");
    } else {
      add_state(output, state, states, "output.", to);
      shown[static_cast<std::size_t>(state)] = 1;
    }
  }
  for (int k = 0; k < static_cast<int>(shown.size()); ++k)
    if (shown[static_cast<std::size_t>(k)] == 0)
      add_state({"state." + states.names[static_cast<std::size_t>(k)], Kind::state, "", k}, k, states, "",
                to);
  for (int k = 0; k < states.indicators; ++k)
    to.add({"indicator." + std::to_string(k + 1), Kind::indicator, "", k});
}

void add_parameter(const text::FileParameter& parameter, int index, List& to) {
  const auto* number = std::get_if<double>(&parameter.value);
  Variable v{parameter.name, number ? Kind::number : Kind::word, parameter.unit, index};
  v.parameter = parameter.name;
  number ? void(v.start = *number) : void(v.word = std::get<std::string>(parameter.value));
  to.add(std::move(v), "parameter.");
}

}  // namespace

bool ExchangedStates::covers(const ExchangedStates& other) const {
  const auto no_more = [](char there, char here) { return there <= here; };
  return other.names == names && other.of_outputs == of_outputs && other.indicators <= indicators &&
         std::equal(other.reset.begin(), other.reset.end(), reset.begin(), no_more);
}

std::vector<Variable> variables(const SubsystemInfo& info, const std::vector<double>& start,
                                const std::vector<text::FileParameter>& parameters,
                                const ExchangedStates* exchange) {
  List list(info.name);
  add_inputs(info, start, list);
  exchange ? add_exchanged(info, *exchange, list) : add_outputs(info, list);
  for (std::size_t k = 0; k < parameters.size(); ++k) add_parameter(parameters[k], static_cast<int>(k), list);
  if (!exchange && info.input_size() > 0) list.add({"extrapolate", Kind::extrapolate}, "parameter.");
  return list.take();
}

}  // namespace tandem::exported
