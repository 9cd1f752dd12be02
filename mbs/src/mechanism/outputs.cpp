// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/outputs.hpp"

#include <algorithm>
#include <cmath>

#include "accelerances.hpp"
#include "element_set.hpp"
#include "equations.hpp"
#include "measurements.hpp"
#include "parts.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"

namespace tandem::mbs {
namespace {

using Kind = Output::Kind;

bool is_motion(Kind kind) {
  return kind == Kind::position || kind == Kind::velocity || kind == Kind::acceleration;
}

bool is_residual(Kind kind) {
  return kind == Kind::position_residual || kind == Kind::velocity_residual ||
         kind == Kind::acceleration_residual;
}

bool is_angle(Kind kind) { return kind == Kind::elevation || kind == Kind::heading; }

bool has_input(const ForceElement& element, int input) {
  const auto& all = element.inputs();
  return std::find(all.begin(), all.end(), input) != all.end();
}

std::string divisor(const std::string& unit) {
  return unit.find_first_of(" /") == std::string::npos ? unit : "(" + unit + ")";
}

bool depends_on_accelerations(Kind kind) {
  return kind == Kind::acceleration || kind == Kind::drive_reaction || kind == Kind::reaction ||
         kind == Kind::acceleration_residual;
}

}  // namespace

Outputs::Outputs(const Mechanism& mechanism) : Outputs(mechanism, mechanism.description().outputs) {}

Outputs::Outputs(const Mechanism& mechanism, std::vector<Output> outputs)
    : mechanism_(mechanism),
      outputs_(std::move(outputs)),
      parts_(connected_parts(mechanism)),
      force_groups_(force_groups(mechanism)),
      measurements_(std::make_unique<Measurements>(mechanism, outputs_)),
      accelerances_(std::make_unique<Accelerances>(mechanism, outputs_)),
      reactions_(std::any_of(outputs_.begin(), outputs_.end(),
                             [](const Output& o) { return o.kind == Kind::reaction; })),
      phi_(mechanism.structure().constraints),
      force_(mechanism.structure().coordinates),
      jacobian_(static_cast<std::size_t>(mechanism.structure().jacobian_values())),
      find_residuals_(mechanism.structure()) {
  for (const Output& o : outputs_) has_residuals_ = has_residuals_ || is_residual(o.kind);
  for (const Output& o : outputs_)
    supports_.push_back(o.kind != Kind::reaction ? Support{} : o.body >= 0 ? body_support(o) : support(o));
}

Outputs::~Outputs() = default;

/// The rows of the body's own mass matrix, weight and equations.
Outputs::Support Outputs::body_support(const Output& output) const {
  const Description& in = mechanism_.description();
  const Structure& structure = mechanism_.structure();
  const Body& body = in.bodies[static_cast<std::size_t>(output.body)];
  Support found{mechanism_.numbering().of(output.coordinate),
                {},
                {},
                static_cast<std::size_t>(structure.constraints),
                true};
  const BodyMass share = body_mass(in, body);
  const Eigen::VectorXd weight = share.weight * in.gravity.head(in.dimension);
  const auto coordinate = [&](int k) {
    return mechanism_.coordinate(share.entities[static_cast<std::size_t>(k / in.dimension)]) +
           k % in.dimension;
  };
  for (int r = 0; r < weight.size(); ++r) {
    if (coordinate(r) != found.coordinate) continue;
    found.weight = weight[r];
    for (int c = 0; c < weight.size(); ++c) found.masses.emplace_back(coordinate(c), share.mass(r, c));
  }
  const int n = structure.variables, row = found.coordinate;
  for (const int e : own_equations(in, structure, mechanism_.numbering(), output.body)) {
    const int entry =
        row < n ? structure.jacobian.find(row, e) : mechanism_.fixed_jacobian().find(row - n, e);
    if (entry >= 0) found.gradients.emplace_back(e, entry + (row < n ? 0 : structure.jacobian.size()));
  }
  return found;
}

Outputs::Support Outputs::support(const Output& output) const {
  const Structure& structure = mechanism_.structure();
  Support found{
      mechanism_.numbering().of(output.coordinate), {}, {}, static_cast<std::size_t>(structure.constraints)};
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
  const char* const length = is_angle(in, c) ? "rad" : "m";
  switch (o.kind) {
    case Kind::position:
      return length;
    case Kind::velocity:
      return std::string(length) + "/s";
    case Kind::acceleration:
      return std::string(length) + "/s^2";
    case Kind::drive_reaction:
      return is_angle(in, c) ? "N m" : "N";
    case Kind::reaction:
      return in.entities[static_cast<std::size_t>(c.entity)].kind == Entity::Kind::vector ? "N m" : "N";
    case Kind::position_residual:
    case Kind::velocity_residual:
    case Kind::acceleration_residual:
      return "1";  // of lengths and angles
    case Kind::elevation:
    case Kind::heading:
      return "rad";
    case Kind::quantity:
      return measurements_->unit(output);
    case Kind::accelerance:
      return std::string(length) + "/s^2/" + divisor(in.inputs[static_cast<std::size_t>(o.input)].unit);
    default:
      return "J";
  }
}

bool Outputs::depends(int output, int input) const {
  const Description& in = mechanism_.description();
  const Output& o = outputs_[static_cast<std::size_t>(output)];
  for (const Drive& drive : in.drives)
    if (drive.input == input && follows(output, parts_[mechanism_.numbering().of(drive.coordinate)]))
      return true;
  if (o.kind == Kind::quantity) return measurements_->follows_inputs(output) && has_input(element(o), input);
  if (!depends_on_accelerations(o.kind)) return false;
  for (const NamedElement& e : in.elements)
    for (const Coordinate& c : e.force->coordinates())
      if (has_input(*e.force, input) && connected(output, parts_[mechanism_.numbering().of(c)])) return true;
  for (const Force& force : in.forces)
    for (const int place : places(mechanism_, force))
      if (force.input == input && connected(output, parts_[place])) return true;
  return false;
}

/// Whether it follows a drive of that part at once: as that part moves, or as forces do to which it belongs.
bool Outputs::follows(int output, int part) const {
  if (connected(output, part)) return true;
  if (!depends_on_accelerations(outputs_[static_cast<std::size_t>(output)].kind)) return false;
  return std::any_of(force_groups_.begin(), force_groups_.end(), [&](const std::vector<int>& group) {
    const auto moves = [&](int c) { return parts_[c] == part; };
    const auto touches = [&](int c) { return connected(output, parts_[c]); };
    return std::any_of(group.begin(), group.end(), moves) && std::any_of(group.begin(), group.end(), touches);
  });
}

const ForceElement& Outputs::element(const Output& o) const {
  return *mechanism_.description().elements[static_cast<std::size_t>(o.element)].force;
}

/// Energies and residuals are of all parts.
bool Outputs::connected(int output, int part) const {
  const Output& o = outputs_[static_cast<std::size_t>(output)];
  const Numbering& at = mechanism_.numbering();
  if (o.kind == Kind::drive_reaction)
    return parts_[at.of(mechanism_.description().drives[static_cast<std::size_t>(o.drive)].coordinate)] ==
           part;
  if (is_motion(o.kind)) return parts_[at.of(o.coordinate)] == part;
  if (is_angle(o.kind)) return parts_[mechanism_.coordinate(o.edge.to)] == part;
  return o.kind != Kind::reaction || supports_[static_cast<std::size_t>(output)].borne(parts_, part);
}

/// Something of that part, or what acts there itself.
bool Outputs::Support::borne(const std::vector<int>& parts, int part) const {
  const auto first = parts.size() - equations;
  const auto in_part = [&](std::size_t number) { return parts[number] == part; };
  return in_part(coordinate) ||
         std::any_of(masses.begin(), masses.end(), [&](const auto& m) { return in_part(m.first); }) ||
         std::any_of(gradients.begin(), gradients.end(),
                     [&](const auto& g) { return in_part(first + g.first); });
}

void Outputs::start(const State& s) { energy_at_start_ = mechanism_.energy(s.q.data(), s.v.data()); }

void Outputs::evaluate(const State& state, double* y) {
  prepare(state);
  for (int k = 0; k < size(); ++k) *y++ = outputs_[static_cast<std::size_t>(k)].gain * value(k, state);
}

void Outputs::prepare(const State& s) {
  measurements_->measure(s);
  accelerances_->find(s);
  if (has_residuals_) residuals_ = find_residuals_(mechanism_, s);
  if (!reactions_) return;
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
    case Kind::elevation:
    case Kind::heading:
      return angle(output, s);
    case Kind::quantity:
      return measurements_->value(number);
    case Kind::accelerance:
      return accelerances_->value(number);
    case Kind::drive_reaction:
      return -s.lambda[mechanism_.drive_equation(output.drive)];
    case Kind::reaction:
      return reaction(supports_[static_cast<std::size_t>(number)], s);
    case Kind::kinetic:
      return mechanism_.kinetic(s.v.data());
    case Kind::potential:
      return mechanism_.potential(s.q.data());
    case Kind::drift:
      return mechanism_.energy(s.q.data(), s.v.data()) - energy_at_start_;
    case Kind::position_residual:
      return residuals_.position;
    case Kind::velocity_residual:
      return residuals_.velocity;
    case Kind::acceleration_residual:
      return residuals_.acceleration;
    default:
      return mechanism_.energy(s.q.data(), s.v.data());
  }
}

/// The equation of motion of a coordinate that does not move, M q'' + Phi_q^T lambda = Q + R; of a body with
/// what is its own alone: its mass, weight and rigidity.
double Outputs::reaction(const Support& support, const State& s) const {
  double sum = support.of_body ? -support.weight : -force_[support.coordinate];
  for (const auto& [column, mass] : support.masses) sum += mass * s.a[column];
  for (const auto& [equation, entry] : support.gradients) sum += jacobian_[entry] * s.lambda[equation];
  return sum;
}

double Outputs::angle(const Output& output, const State& s) const {
  const int d = mechanism_.description().dimension;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  way.head(d) = s.q.segment(mechanism_.coordinate(output.edge.to), d);
  if (output.edge.from >= 0) way.head(d) -= s.q.segment(mechanism_.coordinate(output.edge.from), d);
  const bool level = d == 2 || output.kind == Kind::heading;
  return level ? std::atan2(way[1], way[0]) : std::atan2(way[2], std::hypot(way[0], way[1]));
}

int Outputs::derivatives(int output) const {
  const Output& o = outputs_[static_cast<std::size_t>(output)];
  if (o.kind == Kind::quantity) return measurements_->follows_inputs(output) ? 0 : 1;
  if (o.kind == Kind::accelerance) return 1;
  return o.kind == Kind::position ? 2 : o.kind == Kind::velocity ? 1 : 0;
}

void Outputs::derivatives(const State& s, int order, double* dy) {
  if (order == 1) measurements_->measure_rates(s), accelerances_->find_rates(s);
  for (int k = 0; k < size(); ++k) {
    const Output& output = outputs_[static_cast<std::size_t>(k)];
    if (output.kind == Kind::quantity && derivatives(k) >= order) {
      *dy++ = output.gain * measurements_->rate(k);
      continue;
    }
    if (output.kind == Kind::accelerance) {
      *dy++ = order == 1 ? output.gain * accelerances_->rate(k) : 0.0;
      continue;
    }
    *dy++ = derivatives(k) < order    ? 0.0
            : derivatives(k) == order ? output.gain * s.a[mechanism_.numbering().of(output.coordinate)]
                                      : output.gain * s.v[mechanism_.numbering().of(output.coordinate)];
  }
}

}  // namespace tandem::mbs
