// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "linearized.hpp"
#include "refuse.hpp"
#include "scaled.hpp"
#include "tandem/mbs/mechanism/equilibrium.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;

/// "with P.x = 2, P.y = 0 (m.toml:12)": a place is told where it is not the first one's.
std::string with(const Model& model, const std::vector<Known::Value>& known) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, known.size()); ++k) {
    text += fmt::format("{}{} = {}", k == 0 ? " with " : ", ",
                        model.structure().variable_names[static_cast<std::size_t>(known[k].coordinate)],
                        known[k].value);
    if (known[k].where != known[0].where) text += " (" + known[k].where + ")";
  }
  return text + (known.size() > most ? fmt::format(" and {} more", known.size() - most) : "");
}

/// What can't be found, as a sentence begins, and from what.
struct Problem {
  const char* sentence;
  const std::vector<Known::Value>& known;
  bool of_rates;
};

/// error: Phi at q, or its rate.
[[noreturn]] void impossible(const Model& model, const VectorXd& q, const Problem& problem,
                             const VectorXd& error) {
  std::size_t worst = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(error.size()); ++k)
    if (!(std::abs(error[static_cast<int>(k)]) <= std::abs(error[static_cast<int>(worst)]))) worst = k;
  const Structure& s = model.structure();
  const std::string place = s.constraint_places.empty() ? "" : s.constraint_places[worst];
  const int number = static_cast<int>(worst);
  const Off off = model.off(number, q.data(), error[number]);
  const auto& known = problem.known;
  refuse(known.empty() ? place : known[0].where,
         fmt::format("{}{}: constraint '{}'{} is off by {:.6g}{}", problem.sentence, with(model, known),
                     s.constraint_names[worst], known.empty() || place.empty() ? "" : " (" + place + ")",
                     std::abs(problem.of_rates ? off.per_phi * error[number] : off.now),
                     s.unit_of(number, problem.of_rates)));
}

void find_velocities(Model& of, State& s, const Known& known) {
  Scaled model(of);
  for (const auto& k : known.velocities) s.v[k.coordinate] = k.value;
  model.scale(s);
  Linearized at(model, known.velocities);
  at.evaluate(s.q);
  VectorXd motion(at.phi.size());
  model.constraint_rates(s.q.data(), motion.data());
  const double limit = tolerable(std::max(largest(s.v), largest(motion)));
  VectorXd error = at.rate(s.v) + motion;
  for (int k = 0; k < 4 && !(largest(error) <= 1e-3 * limit); ++k) {
    s.v.head(at.variables()) += at.step(error);
    error = at.rate(s.v) + motion;
  }
  model.restore(s);
  if (!(largest(error) <= limit))
    impossible(of, s.q, {"no velocities fit the constraints", known.velocities, true},
               model.restored_constraints(error));
}

/// Positions that close the constraints, where they come nearest; then Phi of those that stay above the
/// limit, else 0, and nothing if they close.
VectorXd find_positions(Model& of, State& s, const std::vector<Known::Value>& known) {
  Scaled model(of);
  std::vector<Known::Value> lengths = known;
  for (auto& k : lengths) k.value *= model.coordinate_scale(k.coordinate);
  model.scale(s);
  Linearized at(model, lengths);
  const bool closed = assemble(at, s.q, lengths);
  model.restore(s);
  if (closed) return {};
  const auto contradicts = [&](double phi) { return std::abs(phi) <= at.limit ? 0.0 : phi; };
  return model.restored_constraints(at.phi.unaryExpr(contradicts));
}

/// That none is half a turn away from what its edges show.
void check_angles(const Mechanism& mechanism, const State& s) {
  Description stands = mechanism.description();
  for (std::size_t e = 0; e < stands.entities.size(); ++e)
    stands.entities[e].at.head(stands.dimension) =
        s.q.segment(mechanism.coordinate(static_cast<int>(e)), stands.dimension);
  for (std::size_t r = 0; r < stands.relatives.size(); ++r)
    if (const double shown = drawn(stands, stands.relatives[r]),
        angle = s.q[mechanism.numbering().relative[r]];
        stands.relatives[r].kind == Relative::Kind::angle && std::cos(shown - angle) < 0.0)
      refuse(stands.relatives[r].where,
             fmt::format(
                 "angle '{}' is {} rad where the mechanism was assembled, but its edges stand at {}; draw "
                 "them nearer to it",
                 stands.relatives[r].name, angle, shown));
}

std::vector<Known::Value> known(const Mechanism& mechanism, const std::vector<Given>& given) {
  std::vector<Known::Value> values;
  for (const Given& g : given) values.push_back({mechanism.numbering().of(g.coordinate), g.value, g.where});
  return values;
}

/// Forces that drive the mechanism later have no part in where it stands before.
void balance(Mechanism& mechanism, State& s, const Known& given) {
  InputSource* const source = mechanism.source();
  mechanism.set_inputs(nullptr);
  mechanism.reset_inputs();
  const Eigen::VectorXd v = s.v;
  s = equilibrium(mechanism, std::move(s), given);
  s.v = v;
  mechanism.set_inputs(source);
  mechanism.at_time(s.time);
  find_velocities(mechanism, s, given);
}

}  // namespace

State consistent_state(Model& model, State s, const Known& known) {
  model.at_time(s.time);
  const VectorXd off = find_positions(model, s, known.positions);
  if (off.size() > 0)
    impossible(model, s.q, {"the mechanism can't be assembled", known.positions, false}, off);
  find_velocities(model, s, known);
  return s;
}

State initial_state(Mechanism& mechanism, double t) {
  const Description& in = mechanism.description();
  State s = mechanism.described_state();
  s.time = t;
  const Known given{known(mechanism, in.positions), known(mechanism, in.velocities)};
  s = consistent_state(mechanism, std::move(s), given);
  if (in.equilibrium) balance(mechanism, s, given);
  check_angles(mechanism, s);
  return s;
}

Assembled assembled(Mechanism& mechanism, double t) {
  const auto positions = known(mechanism, mechanism.description().positions);
  Assembled result{mechanism.described_state(), {}};
  result.state.time = t;
  mechanism.at_time(t);
  const VectorXd off = find_positions(mechanism, result.state, positions);
  for (int k = 0; k < off.size(); ++k)
    if (off[k] != 0.0)
      result.contradictions.push_back({k, mechanism.off(k, result.state.q.data(), off[k]).now});
  return result;
}

}  // namespace tandem::mbs
