// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/exported/sources.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::exported {
namespace {

using Kind = Variable::Kind;

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

/// What a unit is made for does not change with its parameters.
bool alike(const SubsystemInfo& a, const SubsystemInfo& b) {
  const auto same_ports = [](const std::vector<Port>& one, const std::vector<Port>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](const Port& p, const Port& q) {
      return p.name == q.name && p.size == q.size && p.derivatives == q.derivatives && p.held == q.held;
    });
  };
  const auto same_pair = [](const Feedthrough& f, const Feedthrough& g) {
    return f.output == g.output && f.input == g.input;
  };
  return same_ports(a.inputs, b.inputs) && same_ports(a.outputs, b.outputs) &&
         std::equal(a.feedthrough.begin(), a.feedthrough.end(), b.feedthrough.begin(), b.feedthrough.end(),
                    same_pair) &&
         a.abilities.sampled == b.abilities.sampled &&
         a.abilities.serializes_state == b.abilities.serializes_state;
}

}  // namespace

Unit::Unit(const std::filesystem::path& resources, const Tell& tell)
    : resources_(std::filesystem::absolute(resources)),
      manifest_(read_manifest(resources_ / manifest_name)),
      builtins_(sources(tell)),
      subsystem_(opened()),
      info_(subsystem_->info()),
      variables_(exported::variables(info_, start_values(), file_parameters())),
      inputs_(start_values()),
      parameters_(file_parameters()) {
  rows_.resize(static_cast<std::size_t>(info_.row_size() * most_rows));
}

std::unique_ptr<Subsystem> Unit::opened() const {
  Opening opening{{}, resources_, {}, manifest_.overrides};
  for (const auto* values : {&manifest_.parameters, &changed_})
    for (const auto& [name, value] : *values) opening.parameters.set(name, value);
  return open(manifest_.source, builtins_, std::move(opening));
}

void Unit::reopen() {
  auto subsystem = opened();
  if (!alike(subsystem->info(), info_))
    refuse("'" + info_.name +
           "' has other ports, or gives other derivatives of outputs, with these parameters than with those "
           "that "
           "it was exported with; allowed is another export");
  subsystem_ = std::move(subsystem);
}

/// Of the source's file, with their values as they are.
std::vector<text::FileParameter> Unit::file_parameters() const {
  Parameters given;
  for (const auto* values : {&manifest_.parameters, &changed_})
    for (const auto& [name, value] : *values) given.set(name, value);
  return scenario::parameters_of(manifest_.source, resources_, manifest_.overrides, given);
}

std::vector<double> Unit::start_values() const {
  std::vector<double> values;
  for (int k = 0; k < info_.input_size(); ++k) {
    const Scalar scalar = scalar_at(info_.inputs, k);
    const auto it = manifest_.starts.find(scalar.name());
    const double own = scalar.port->start_of(scalar.element);
    values.push_back(it != manifest_.starts.end() ? it->second : std::isnan(own) ? 0.0 : own);
  }
  return values;
}

const Variable& Unit::variable(std::size_t reference) const {
  if (reference < variables_.size()) return variables_[reference];
  refuse(fmt::format("there is no variable of value reference {}; allowed are 0 to {}", reference,
                     variables_.size() - 1));
}

const Variable& Unit::of_kind(std::size_t reference, Kind kind, const char* wanted) const {
  const Variable& v = variable(reference);
  if (v.kind != kind) refuse(fmt::format("variable '{}' is no {}", v.name, wanted));
  return v;
}

std::vector<std::string> Unit::allowed_words(std::size_t reference) const {
  const Variable& v = variable(reference);
  if (v.kind != Kind::word) return {};
  return parameters_[static_cast<std::size_t>(v.index)].allowed;
}

void Unit::set_span(double start, double stop) {
  if (begun_) throw Error(ErrorCode::wrong_state, "start and stop are given after the start was made");
  if (!std::isfinite(start) || std::isnan(stop) || stop <= start)
    refuse(fmt::format("the start is at {} s, the stop at {} s; allowed is a stop after a finite start",
                       start, stop));
  start_ = time_ = place_ = start, stop_ = stop, fresh_ = false;
}

void Unit::set(std::size_t reference, double value) {
  const Variable& v = variable(reference);
  if (!std::isfinite(value))
    refuse(fmt::format("variable '{}' at t = {} s is {}; allowed is a finite number", v.name, time_, value));
  if (v.kind == Kind::number) return change(v, value);
  inputs_.set(of_kind(reference, Kind::input, "input or parameter that is a number").index, value);
  fresh_ = fresh_ && begun_;
  inputs_set_ = true;
}

void Unit::set(std::size_t reference, const std::string& word) {
  change(of_kind(reference, Kind::word, "parameter that is a text"), word);
}

void Unit::set(std::size_t reference, bool flag) {
  const Variable& v = of_kind(reference, Kind::extrapolate, "Boolean");
  check_not_begun(v);
  inputs_.extrapolate(flag);
}

void Unit::check_not_begun(const Variable& v) const {
  if (begun_)
    refuse(fmt::format("parameter '{}' is set at t = {} s; allowed is to set it before the start", v.name,
                       time_));
}

void Unit::change(const Variable& v, Parameters::Value value) {
  check_not_begun(v);
  changed_[v.parameter] = std::move(value);
  parameters_ = file_parameters();
  subsystem_.reset();
  fresh_ = false;
}

void Unit::set_derivative(std::size_t reference, int order, double value) {
  const Variable& v = of_kind(reference, Kind::input, "input");
  if (!std::isfinite(value))
    refuse(fmt::format("derivative {} of '{}' at t = {} s is {}; allowed is a finite number", order, v.name,
                       time_, value));
  inputs_.set_derivative(v.index, order, value);
}

double Unit::number(std::size_t reference) {
  const Variable& v = variable(reference);
  switch (v.kind) {
    case Kind::time:
      return time_;
    case Kind::input:
      return inputs_.value(v.index);
    case Kind::output:
      follow_inputs();
      return row_[static_cast<std::size_t>(v.index)];
    case Kind::derivative:
      return derivative(reference, v.order);
    case Kind::number:
      return std::get<double>(parameters_[static_cast<std::size_t>(v.index)].value);
    default:
      refuse(fmt::format("variable '{}' is no number", v.name));
  }
}

std::string Unit::word(std::size_t reference) const {
  const Variable& v = of_kind(reference, Kind::word, "parameter that is a text");
  return std::get<std::string>(parameters_[static_cast<std::size_t>(v.index)].value);
}

bool Unit::flag(std::size_t reference) const {
  of_kind(reference, Kind::extrapolate, "Boolean");
  return inputs_.extrapolates();
}

double Unit::derivative(std::size_t reference, int order) {
  const Variable& v = variable(reference);
  const bool known = v.kind == Kind::output || v.kind == Kind::derivative;
  if (!known || order < 1 || order > scalar_at(info_.outputs, v.index).port->derivatives)
    refuse(fmt::format("variable '{}' has no time derivative of order {}", v.name, order));
  follow_inputs();
  return row_[static_cast<std::size_t>(order * info_.output_size() + v.index)];
}

}  // namespace tandem::exported
