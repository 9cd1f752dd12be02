// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/outputs.hpp"

#include <algorithm>

namespace tandem::mbs {
namespace {

using Kind = Output::Kind;

bool is_motion(Kind kind) {
  return kind == Kind::position || kind == Kind::velocity || kind == Kind::acceleration;
}

}  // namespace

Outputs::Outputs(const Mechanism& mechanism)
    : mechanism_(mechanism),
      outputs_(mechanism.description().outputs),
      reactions_(std::any_of(outputs_.begin(), outputs_.end(),
                             [](const Output& o) { return o.kind == Kind::reaction; })),
      phi_(mechanism.structure().constraints),
      force_(mechanism.structure().coordinates),
      jacobian_(static_cast<std::size_t>(mechanism.structure().jacobian_values())) {
  for (const Output& o : outputs_) supports_.push_back(o.kind == Kind::reaction ? support(o) : Support{});
}

Outputs::Support Outputs::support(const Output& output) const {
  const Structure& structure = mechanism_.structure();
  Support found{mechanism_.numbering().of(output.coordinate), {}, {}};
  const int row = found.coordinate - structure.variables;
  const Matrix& mass = mechanism_.fixed_mass();
  const auto masses = mass.pattern.entries(), gradients = mechanism_.fixed_jacobian().entries();
  for (std::size_t k = 0; k < masses.size(); ++k)
    if (masses[k].first == row) found.masses.emplace_back(masses[k].second, mass.values[k]);
  for (std::size_t k = 0; k < gradients.size(); ++k)
    if (gradients[k].first == row)
      found.gradients.emplace_back(gradients[k].second, structure.jacobian.size() + k);
  return found;
}

std::string Outputs::unit(int output) const {
  const Description& in = mechanism_.description();
  const Output& o = outputs_[static_cast<std::size_t>(output)];
  const Coordinate& c = o.drive >= 0 ? in.drives[static_cast<std::size_t>(o.drive)].coordinate : o.coordinate;
  const std::string length = is_angle(in, c) ? "rad" : "m";
  switch (o.kind) {
    case Kind::position:
      return length;
    case Kind::velocity:
      return length + "/s";
    case Kind::acceleration:
      return length + "/s^2";
    case Kind::drive_reaction:
      return is_angle(in, c) ? "N m" : "N";
    case Kind::reaction:
      return in.entities[static_cast<std::size_t>(c.entity)].kind == Entity::Kind::vector ? "N m" : "N";
    default:
      return "J";
  }
}

bool Outputs::depends(int output, int input) const {
  const Description& in = mechanism_.description();
  const Kind kind = outputs_[static_cast<std::size_t>(output)].kind;
  const bool at_once = kind == Kind::acceleration || kind == Kind::drive_reaction || kind == Kind::reaction;
  const auto uses = [input](const auto& element) { return element.input == input; };
  return std::any_of(in.drives.begin(), in.drives.end(), uses) ||
         (at_once && std::any_of(in.forces.begin(), in.forces.end(), uses));
}

void Outputs::evaluate(const State& state, double* y) {
  if (reactions_) prepare_reactions(state);
  for (int k = 0; k < size(); ++k) *y++ = value(k, state);
}

void Outputs::prepare_reactions(const State& s) {
  mechanism_.constraints(s.q.data(), phi_.data(), jacobian_.data());
  mechanism_.all_forces(s.q.data(), s.v.data(), force_.data());
}

double Outputs::value(int number, const State& s) const {
  const Output& output = outputs_[static_cast<std::size_t>(number)];
  const int i = is_motion(output.kind) ? mechanism_.numbering().of(output.coordinate) : 0;
  switch (output.kind) {
    case Kind::position:
      return s.q[i];
    case Kind::velocity:
      return s.v[i];
    case Kind::acceleration:
      return s.a[i];
    case Kind::drive_reaction:
      return -s.lambda[mechanism_.drive_equation(output.drive)];
    case Kind::reaction:
      return reaction(supports_[static_cast<std::size_t>(number)], s);
    case Kind::kinetic:
      return mechanism_.kinetic(s.v.data());
    case Kind::potential:
      return mechanism_.potential(s.q.data());
    default:
      return mechanism_.energy(s.q.data(), s.v.data());
  }
}

/// The equation of motion of a coordinate that does not move, M q'' + Phi_q^T lambda = Q + R.
double Outputs::reaction(const Support& support, const State& s) const {
  double sum = -force_[support.coordinate];
  for (const auto& [column, mass] : support.masses) sum += mass * s.a[column];
  for (const auto& [equation, entry] : support.gradients) sum += jacobian_[entry] * s.lambda[equation];
  return sum;
}

int Outputs::derivatives(int output) const {
  const Kind kind = outputs_[static_cast<std::size_t>(output)].kind;
  return kind == Kind::position ? 2 : kind == Kind::velocity ? 1 : 0;
}

void Outputs::derivatives(const State& s, int order, double* dy) const {
  for (int k = 0; k < size(); ++k) {
    const Output& output = outputs_[static_cast<std::size_t>(k)];
    *dy++ = derivatives(k) < order    ? 0.0
            : derivatives(k) == order ? s.a[mechanism_.numbering().of(output.coordinate)]
                                      : s.v[mechanism_.numbering().of(output.coordinate)];
  }
}

}  // namespace tandem::mbs
