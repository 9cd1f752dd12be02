// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "slow_mechanism.hpp"

#include <algorithm>
#include <array>

#include "tandem/bytes.hpp"
#include "tandem/mbs/mechanism/push.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {
namespace {

const std::string reaction = "reaction.", coordinate = "coordinate.";

void copy(const Eigen::VectorXd& from, std::span<double> to) {
  std::copy_n(from.begin(), to.size(), to.begin());
}

Eigen::VectorXd vector_of(std::span<const double> x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// By variable.
std::vector<Coordinate> coordinates_of(const Description& d) {
  std::vector<Coordinate> all;
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e)
    for (int axis = 0; axis < d.dimension && !d.entities[static_cast<std::size_t>(e)].fixed; ++axis)
      all.push_back({e, axis});
  for (int r = 0; r < static_cast<int>(d.relatives.size()); ++r) all.push_back({-1, 0, r});
  return all;
}

/// An output of a coordinate and an input of a force on it.
void take(Description& d, const Coordinate& of, const std::string& name) {
  d.outputs.push_back({coordinate + name, Output::Kind::position, of});
  Input input{reaction + name, ""};
  input.value = 0.0;
  Force force{input.name, Force::Kind::relative, of.relative};
  if (of.entity >= 0) {
    force.kind = Force::Kind::point, force.index = of.entity;
    force.direction[of.axis] = 1.0;
  }
  force.input = static_cast<int>(d.inputs.size());
  d.inputs.push_back(std::move(input)), d.forces.push_back(std::move(force));
}

}  // namespace

SlowMechanism::SlowMechanism(const Description& description, WhereItIs where, std::vector<Link> links,
                             std::vector<int> variables)
    : where_(std::move(where)),
      links_(std::move(links)),
      own_(description),
      reduced_(own_, std::move(variables), own_.described_state().q),
      silent_(description.inputs.size()),
      inputs_(silent_.size()) {
  for (const Link& link : links_) silent_[static_cast<std::size_t>(link.input)] = true;
  for (std::size_t k = 0; k < silent_.size(); ++k)
    if (description.inputs[k].name.starts_with(reaction)) silent_[k] = true;
  own_.set_inputs(this);
}

/// Others than the independent coordinates are looked for from where the mechanism has them that moves.
void SlowMechanism::stand_at(double t) {
  Eigen::VectorXd q;
  where_(q, inputs_);
  time_ = t;
  reduced_.begin_at(q);
  own_.at_time(t);
}

/// Those with a function of time are its own.
void SlowMechanism::at(double, std::span<InputValue> values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (silent_[k])
      values[k] = {};
    else if (!own_.description().inputs[k].function)
      values[k] = inputs_[k];
}

std::vector<std::string> SlowMechanism::named(const char* prefix) const {
  std::vector<std::string> all;
  for (const int variable : reduced_.variables())
    all.push_back(prefix + own_.numbering().variable_names[static_cast<std::size_t>(variable)]);
  return all;
}

std::vector<double> SlowMechanism::units() const {
  const Structure& s = own_.structure();
  std::vector<double> all;
  for (const int variable : reduced_.variables())
    all.push_back(s.coordinate_scales.empty()
                      ? s.length
                      : s.length / s.coordinate_scales[static_cast<std::size_t>(variable)]);
  return all;
}

void SlowMechanism::accelerations(std::span<const double> q, std::span<const double> u, std::span<double> a) {
  reduced_.stand_at(vector_of(q));
  copy(reduced_.accelerations(vector_of(u)), a);
}

void SlowMechanism::answer(std::span<const double> q, std::span<const double> b, std::span<double> a) {
  reduced_.stand_at(vector_of(q));
  copy(reduced_.answer(vector_of(b)), a);
}

void SlowMechanism::inertia(std::span<const double> q, std::span<const double> a, std::span<double> b) {
  reduced_.stand_at(vector_of(q));
  copy(reduced_.mass() * vector_of(a), b);
}

void SlowMechanism::pushes(std::span<const double> q, std::span<double> b) {
  reduced_.stand_at(vector_of(q));
  for (std::size_t k = 0; k < links_.size(); ++k)
    copy(reduced_.reduced(push_of(own_, links_[k].input, reduced_.q())), b.subspan(k * q.size(), q.size()));
}

void SlowMechanism::motions(std::span<const double> q, std::span<const double> u, std::span<double> y,
                            std::span<double> rates) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const auto& all = reduced_.variables();
    const auto at =
        static_cast<std::size_t>(std::find(all.begin(), all.end(), links_[k].variable) - all.begin());
    y[k] = links_[k].gain * q[at], rates[k] = links_[k].gain * u[at];
  }
}

void SlowMechanism::write(ByteWriter& to) const {
  to.put(time_);
  to.put_doubles({reduced_.q().data(), static_cast<std::size_t>(reduced_.q().size())});
  for (const InputValue& one : inputs_) to.put_doubles(std::array{one.value, one.rate, one.acceleration});
}

void SlowMechanism::read(ByteReader& from) {
  time_ = from.take<double>();
  Eigen::VectorXd q = reduced_.q();
  for (double& one : q) one = from.take<double>();
  for (InputValue& one : inputs_) one = {from.take<double>(), from.take<double>(), from.take<double>()};
  reduced_.begin_at(q);
  own_.at_time(time_);
}

std::shared_ptr<SlowModel> slow_model_of(const Description& d, WhereItIs where, const std::vector<int>& ports,
                                         std::span<const SlowLink> links) {
  const Numbering numbering(d);
  const auto takes_force = [&](const std::string& name) {
    return std::any_of(d.inputs.begin(), d.inputs.end(),
                       [&](const Input& one) { return one.name == reaction + name; });
  };
  std::vector<int> variables;
  for (const Output& o : d.outputs)
    if (o.name.starts_with(coordinate) && takes_force(o.name.substr(coordinate.size())))
      variables.push_back(numbering.of(o.coordinate));
  std::vector<SlowMechanism::Link> all;
  for (const SlowLink& link : links) {
    const int input = ports[static_cast<std::size_t>(link.force)];
    const Output& y = d.outputs[static_cast<std::size_t>(link.displacement)];
    const int variable = y.kind == Output::Kind::position ? numbering.of(y.coordinate) : -1;
    const bool has_port = std::find(variables.begin(), variables.end(), variable) != variables.end();
    if (!has_port || !only_forces_follow(d, input)) return nullptr;
    all.push_back({input, variable, y.gain});
  }
  return std::make_shared<SlowMechanism>(d, std::move(where), std::move(all), std::move(variables));
}

void take_reactions(Description& d, const std::vector<std::string>& displacements) {
  const Mechanism m(d);
  const auto coordinates = coordinates_of(d);
  std::vector<int> wanted, liked;
  for (const Output& o : d.outputs) {
    const int variable =
        o.kind == Output::Kind::position ? m.numbering().of(o.coordinate) : m.structure().variables;
    const bool is_one = std::find(displacements.begin(), displacements.end(), o.name) != displacements.end();
    if (is_one && variable >= m.structure().variables) return;
    if (is_one && std::find(wanted.begin(), wanted.end(), variable) == wanted.end())
      wanted.push_back(variable);
  }
  for (int v = 0; v < static_cast<int>(coordinates.size()); ++v)
    if (coordinates[static_cast<std::size_t>(v)].entity < 0) liked.push_back(v);
  if (wanted.empty() || !m.structure().states.empty()) return;
  for (const int v : independent_variables(m, m.described_state().q, wanted, liked))
    take(d, coordinates[static_cast<std::size_t>(v)],
         m.numbering().variable_names[static_cast<std::size_t>(v)]);
}

}  // namespace tandem::mbs
