// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/functions/functions.hpp"

namespace tandem::mbs {

std::string_view name(Term term) {
  switch (term) {
    case Term::mass:
      return "mass";
    case Term::constraints:
      return "constraints";
    case Term::jacobian:
      return "jacobian";
    case Term::constraint_accelerations:
      return "constraint_accelerations";
    case Term::forces:
      return "forces";
    case Term::constraint_rates:
      return "constraint_rates";
    case Term::stiffness:
      return "stiffness";
    case Term::damping:
      return "damping";
    case Term::energy:
      break;
  }
  return "energy";
}

Shape shape(Term term, const FunctionsInfo& info) {
  const int n = info.size(), m = info.constraints;
  switch (term) {
    case Term::mass:
    case Term::stiffness:
    case Term::damping:
      return {n, n};
    case Term::constraints:
    case Term::constraint_accelerations:
    case Term::constraint_rates:
      return {m, 1};
    case Term::jacobian:
      return {m, n};
    case Term::forces:
      return {n, 1};
    case Term::energy:
      break;
  }
  return {1, 1};
}

}  // namespace tandem::mbs
