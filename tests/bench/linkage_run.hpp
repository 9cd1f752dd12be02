// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::bench {

/// A row of `tandem bench four_bar`. solver: one of mbs::solver_names, or "generic", which is GenericIndex3.
struct LinkageCase {
  std::string solver;
  int loops;
  double step, tolerance;  ///< [s], [m]
  auto operator<=>(const LinkageCase&) const = default;
};

/// The linkage in motion, by the index-3 formulation with alpha = 1e8. It begins at the start.
class LinkageRun {
 public:
  /// `linkage` has as many loops as the case and outlives this, and one run at a time takes steps. Throws
  /// Error as mbs::Index3 does, and so do the others.
  LinkageRun(const LinkageCase& c, mbs::Mechanism& linkage);

  /// Back to the start.
  void begin();
  /// Takes so many steps more; the seconds that they took.
  double steps(long count);

  double iterations() const { return static_cast<double>(iterations_) / static_cast<double>(done_); }
  /// Of the first moving point's x, against the truth [m].
  double x_error() const;
  /// Of the energy since the start, over the potential energy then.
  double drift() const;

 private:
  const int loops_;
  const double h_;
  mbs::Mechanism& linkage_;
  std::unique_ptr<mbs::Stepper> stepper_;
  mbs::State s_;
  long done_ = 0, iterations_ = 0;
};

}  // namespace tandem::bench
