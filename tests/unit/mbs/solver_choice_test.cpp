// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/solver_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tandem::mbs {
namespace {

/// Columns next to each other are coupled over `width`, the last with the first if it is a ring.
Pattern band(int size, int width, bool ring = false) {
  std::vector<std::pair<int, int>> entries;
  for (int c = 0; c < size; ++c)
    for (int k = 0; k <= width; ++k)
      if (c + k < size || ring) entries.insert(entries.end(), {{c, (c + k) % size}, {(c + k) % size, c}});
  return {size, size, entries};
}

/// A column with b entries below it takes b multiplications by the pivot and b (b + 1) / 2 for what it
/// changes.
TEST(EliminationCost, CountsWhatEliminationTakes) {
  const auto chain = elimination_cost(band(10, 1));
  EXPECT_EQ(chain.columns, 10);
  EXPECT_EQ(chain.band_width, 1);
  EXPECT_EQ(chain.entries, 9.0);
  EXPECT_EQ(chain.operations, 9.0 * 2.0);

  const auto full = elimination_cost(band(5, 4));
  EXPECT_EQ(full.band_width, 4);
  EXPECT_EQ(full.entries, 10.0);
  EXPECT_EQ(full.operations, 2.0 + 5.0 + 9.0 + 14.0);

  const auto ring = elimination_cost(band(10, 1, true));  // each elimination but the last joins two ends
  EXPECT_EQ(ring.band_width, 2);
  EXPECT_EQ(ring.entries, 8.0 * 2.0 + 1.0);
}

TEST(SolverChoice, IsTheBandSolverForAChainAndKluForAnUnsymmetricOne) {
  for (const int size : {12, 82, 1002}) {
    EXPECT_EQ(solver_choice(MatrixKind::positive_definite, band(size, 3)), "band");
    EXPECT_EQ(solver_choice(MatrixKind::unsymmetric, band(size, 3)), "klu");
  }
}

TEST(SolverChoice, IsASolverOfThisBuildForTheKind) {
  for (const MatrixKind kind :
       {MatrixKind::positive_definite, MatrixKind::symmetric, MatrixKind::unsymmetric})
    for (const int size : {1, 30, 300})
      for (const int width : {0, 2, 20, 250}) {
        const auto names = solver_names(kind);
        const auto choice = solver_choice(kind, band(size, std::min(width, size - 1)));
        EXPECT_NE(std::find(names.begin(), names.end(), choice), names.end()) << choice;
        EXPECT_NE(choice, "auto");
      }
}

}  // namespace
}  // namespace tandem::mbs
