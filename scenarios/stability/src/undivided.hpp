// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <string>
#include <vector>

#include "trial.hpp"

namespace tandem::stability {

/// The coupled system as one that nothing divides: z' = rates z and y = outputs z about the start, z the states of all
/// subsystems, y their outputs.
struct Undivided {
  Eigen::MatrixXd rates;  ///< [1/s]
  Eigen::MatrixXd outputs;
  std::vector<std::string> names;                 ///< empty: a held output
  std::vector<Eigen::Index> state_at, output_at;  ///< of each subsystem, where its own begin
  std::vector<Eigen::Index> held_at;  ///< likewise outputs that are in effect, and behind them later ones

  Eigen::Index state_of(int instance) const { return state_at[static_cast<std::size_t>(instance)]; }
  Eigen::Index output_of(int instance) const { return output_at[static_cast<std::size_t>(instance)]; }
  Eigen::Index held_of(int instance) const { return held_at[static_cast<std::size_t>(instance)]; }
};

/// What becomes of sampled subsystems: their outputs stay what they are at the start, or are numbers of z, as are their
/// states; none of these flows.
enum class Sampled { left_out, held };

/// From what each subsystem makes of its own states and of constant inputs over one step, which is shortened by
/// halves (where it lands) until no mode turns by more than half a radian in it:
///   [x; u] moves by E = exp([G b; 0 0] h), so [G b; 0 0] = log(E) / h,
/// and by Richardson's extrapolation of G and b over three such steps, in which the integrator's own error goes.
/// With y = C x + D u from the same steps and u = L y of the connections: rates = G + b (1 - L D)^-1 L C. Lags are
/// left out. is_linear: the differences may be large. Throws Error(not_supported) for connections that make a loop at once
/// and for a subsystem that follows rates of its inputs (a prescribed motion), as constant inputs tell nothing of these.
Undivided undivided(const Trial& trial, bool is_linear, Sampled sampled = Sampled::left_out);

/// Its modes: their rates [1/s], and by columns their vectors and how much each state takes part, the product of a state in the mode and of the
/// mode in the state, which has no unit (I. J. Perez-Arriaga et al., IEEE Trans. Power Apparatus and Systems 101, 1982).
struct Participation {
  Eigen::VectorXcd rates;
  Eigen::MatrixXcd vectors;
  Eigen::MatrixXd parts;
};
Participation participation(const Undivided& whole);

}  // namespace tandem::stability
