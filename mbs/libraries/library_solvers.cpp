// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "library_solvers.hpp"

#ifdef TANDEM_HAS_METIS
#include <metis.h>
#endif

#include "solvers/order.hpp"

namespace tandem::mbs::solvers {

std::vector<SolverEntry> library_solvers() {
  using enum MatrixKind;
  return {
      {"klu", unsymmetric, klu},
      {"klu_full", unsymmetric, klu_full},
#ifdef TANDEM_HAS_LAPACK
      {"lapack", symmetric, lapack},
      {"lapack_lu", unsymmetric, lapack_lu},
      {"lapack_band", unsymmetric, lapack_band},
#endif
  };
}

std::vector<int> dissection_order([[maybe_unused]] const Pattern& pattern) {
#ifdef TANDEM_HAS_METIS
  static_assert(sizeof(idx_t) == sizeof(int));
  idx_t columns = pattern.columns();
  std::vector<int> starts = {0}, neighbours;  // METIS wants no diagonal
  for (int c = 0; c < columns; ++c) {
    for (int k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k)
      if (pattern.indices()[k] != c) neighbours.push_back(pattern.indices()[k]);
    starts.push_back(static_cast<int>(neighbours.size()));
  }
  std::vector<int> order(static_cast<std::size_t>(columns)), place(order.size());
  if (neighbours.empty() || METIS_NodeND(&columns, starts.data(), neighbours.data(), nullptr, nullptr,
                                         order.data(), place.data()) != METIS_OK)
    return {};
  return order;
#else
  return {};
#endif
}

}  // namespace tandem::mbs::solvers
