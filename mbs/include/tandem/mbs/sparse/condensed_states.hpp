// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::mbs {

struct ModelMatrices;
struct TangentFactors;

/// Eliminates a model's states (Structure::states) from its tangent by hand. With d the diagonal entry of a
/// state, c its column and r its row, A - c r / d is left. The symmetric part of that stands for the rest. A
/// solution takes two multiplications by c and r more.
class CondensedStates {
 public:
  CondensedStates(const Structure& structure, const Layout& layout);

  /// Numbers that assemble() keeps.
  std::size_t size() const { return size_; }
  /// base: by position of the layout, M + damping C + stiffness K without what couples states.
  void assemble(const ModelMatrices& at, const TangentFactors& factors, double* base, double* kept) const;
  /// Before and after b is solved with the matrix that is left.
  void reduce(const double* kept, double* b) const;
  void expand(const double* kept, double* x) const;

 private:
  struct Coupling {
    int variable, in_column, in_row;  ///< positions in K and C; -1: none
  };
  struct Fill {
    std::size_t to;
    int row, column;  ///< of the state's couplings
  };
  struct One {
    int variable;
    double mass;
    int diagonal;    ///< position in K and C; -1: none
    std::size_t at;  ///< position of the diagonal in the layout
    std::vector<Coupling> couplings;
    std::vector<Fill> fill;
  };
  std::vector<One> all_;
  std::size_t size_ = 0;
};

}  // namespace tandem::mbs
