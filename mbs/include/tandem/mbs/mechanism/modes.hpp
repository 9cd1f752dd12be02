// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// A solution exp(p t) shape of the motion linearized about a state.
struct Mode {
  std::complex<double> p;  ///< [1/s]
  Eigen::VectorXcd shape;  ///< of the variables; largest entry 1

  bool oscillates() const { return p.imag() != 0.0; }
  double frequency() const;  ///< |p| / 2 pi [Hz]; a damped one swings with |Im p| / 2 pi
  double damping() const;    ///< ratio -Re p / |p|; 1 or -1 where nothing oscillates
};

/// The modes of M q'' = Q - Phi_q^T lambda about a state at rest (accelerations and velocities count as zero
/// but in Q), with the constraints' curvature. M_r = R^T M R and so on, R a basis of what the constraints
/// leave (J. Garcia de Jalon, E. Bayo, 1994, ch. 5), K and C by central differences. Of each pair of
/// conjugate solutions one; by ascending frequency; none where the constraints leave no motion. Throws Error
/// for a motion without mass, and where an input has no value.
std::vector<Mode> modes(Model& model, const State& state);

/// What has how much of a mode's kinetic energy: a body along or about an axis of the drawing ("chassis about
/// y"), a mass, a coordinate with an inertia. Parts of 1, the largest first.
struct Share {
  std::string name;
  double part;
};
std::vector<Share> shares(const Mechanism& mechanism, const Mode& mode);

/// The largest share's, by the words of vehicles where that is the heaviest body in space ("heave", "pitch"),
/// else as there.
std::string name_of(const Mechanism& mechanism, const Mode& mode);

}  // namespace tandem::mbs
