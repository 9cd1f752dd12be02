// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/exported/sources.hpp"
#include "tandem/scenario/nested.hpp"

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
      inputs_({}),
      builtins_(sources(tell)) {
  subsystem_ = opened();
  info_ = subsystem_->info();
  parameters_ = file_parameters();
  variables_ = exported::variables(info_, start_values(), parameters_);
  inputs_ = Inputs(start_values());
}

Parameters Unit::given() const {
  Parameters all;
  for (const auto* values : {&manifest_.parameters, &changed_})
    for (const auto& [name, value] : *values) all.set(name, value);
  return all;
}

std::unique_ptr<Subsystem> Unit::opened() const {
  return open(manifest_.source, builtins_, {given(), resources_, {}, manifest_.overrides});
}

void Unit::reopen() {
  auto subsystem = opened();
  if (!alike(subsystem->info(), info_))
    refuse("'" + info_.name +
           "' has other ports, or gives other derivatives of outputs, with these parameters than with those "
           "that "
           "it was exported with; allowed is another export");
  open_source();
  subsystem_ = std::move(subsystem);
}

/// Of the source's file, with their values as they are.
std::vector<text::FileParameter> Unit::file_parameters() const {
  Parameters values = given();
  return scenario::parameters_of(manifest_.source, resources_, manifest_.overrides, values);
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

/// The start is made once with all as it is.
void Unit::start() {
  if (fresh_) return;
  if (!subsystem_) reopen();
  at_start_ = inputs_.values();
  start_source();
  fresh_ = true;
}

void Unit::begin() {
  start();
  if (!begun_) begin_source();
  begun_ = true;
}

void Unit::check_begun() const {
  if (!begun_) throw Error(ErrorCode::wrong_state, "'" + info_.name + "' has not made its start yet");
}

void Unit::reset() {
  changed_.clear();
  parameters_ = file_parameters();
  subsystem_.reset();
  inputs_ = Inputs(start_values());
  fresh_ = begun_ = inputs_set_ = false;
  set_span(0.0);
}

}  // namespace tandem::exported
