// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::mbs {

/// The terms of M q'' + Phi_q^T lambda = Q(t, q, q'), Phi(t, q) = 0, n variables, m constraints, SI units.
enum class Term {
  mass,                      ///< M, n x n, constant, symmetric
  constraints,               ///< Phi(t, q), m x 1
  jacobian,                  ///< Phi_q(t, q), m x n
  constraint_accelerations,  ///< gamma(t, q, q') in Phi'' = Phi_q q'' + gamma, m x 1
  forces,                    ///< Q(t, q, q'), n x 1
  constraint_rates,          ///< Phi_t(t, q), m x 1; from here on terms may be absent. Zero if so
  stiffness,                 ///< K = -dQ/dq (t, q, q'), n x n; zero if absent, and Newton takes longer
  damping,                   ///< C = -dQ/dq' (t, q, q'), n x n; the same
  energy                     ///< kinetic and potential (t, q, q') [J], 1 x 1; there is then no such output
};
constexpr std::array terms = {
    Term::mass,   Term::constraints,      Term::jacobian,  Term::constraint_accelerations,
    Term::forces, Term::constraint_rates, Term::stiffness, Term::damping,
    Term::energy};
std::string_view name(Term term);
constexpr bool may_be_absent(Term term) { return term >= Term::constraint_rates; }

/// What does not change while a model moves, and where it starts.
struct FunctionsInfo {
  std::string name;
  std::vector<std::string> variables, units;  ///< of each variable its name and unit
  int constraints = 0;
  Eigen::VectorXd q, v;  ///< that satisfy the constraints at t = 0
  std::array<bool, terms.size()> present = {};

  int size() const { return static_cast<int>(variables.size()); }
  bool has(Term term) const { return present[static_cast<std::size_t>(term)]; }
};

struct Shape {
  int rows, columns;
  int size() const { return rows * columns; }
  bool operator==(const Shape&) const = default;
};
Shape shape(Term term, const FunctionsInfo& info);

/// The terms of a model as functions that are evaluated somewhere else: in a shared library, in another
/// process.
class Functions {
 public:
  virtual ~Functions() = default;
  virtual const FunctionsInfo& info() const = 0;
  /// The values of a term by columns; as many as its shape has. Those of q and v that it has not as arguments
  /// are ignored. Throws Error with the name of the term and the time where it can't be had.
  virtual void evaluate(Term term, double t, const double* q, const double* v, std::span<double> values) = 0;
};

}  // namespace tandem::mbs
