// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::test {

bool add_thesis_solvers() {
  using enum mbs::MatrixKind;
  static const bool added = [] {
#ifdef TANDEM_HAS_CHOLMOD
    mbs::add_solver("cholmod", positive_definite, cholmod);
    mbs::add_solver("cholmod_supernodal", positive_definite, cholmod_supernodal);
#endif
#ifdef TANDEM_HAS_UMFPACK
    mbs::add_solver("umfpack", unsymmetric, umfpack);
#endif
#ifdef TANDEM_HAS_SUPERLU
    mbs::add_solver("superlu", unsymmetric, superlu);
#endif
#ifdef TANDEM_HAS_MUMPS
    mbs::add_solver("mumps", unsymmetric, mumps);
#endif
    mbs::add_solver("ldlt", positive_definite, ldlt);
    return true;
  }();
  return added;
}

}  // namespace tandem::test
