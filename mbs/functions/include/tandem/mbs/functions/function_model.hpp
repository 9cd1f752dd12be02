// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "tandem/mbs/functions/functions.hpp"
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// Functions as a model, with dense matrices. Throws Error(numerical) that names model, term, time and entry
/// where a value is not finite, and where the mass matrix is not symmetric.
class FunctionModel final : public Model {
 public:
  explicit FunctionModel(std::unique_ptr<Functions> functions);

  const FunctionsInfo& info() const { return functions_->info(); }
  /// At time t, with the q and v of the functions' info.
  State initial(double t) const;

  const Structure& structure() const override { return structure_; }
  void at_time(double t) override { time_ = t; }
  void constraints(const double* q, double* phi, double* jacobian) const override;
  void constraint_rates(const double* q, double* phi_t) const override;
  void constraint_accelerations(const double* q, const double* v, double* gamma) const override;
  void forces(const double* q, const double* v, double* force) const override;
  void force_derivatives(const double* q, const double* v, double* k, double* c) const override;
  /// NaN without that function.
  double energy(const double* q, const double* v) const override;

 private:
  void evaluate(Term term, const double* q, const double* v, double* values) const;
  void take_mass();

  std::unique_ptr<Functions> functions_;
  Structure structure_;
  mutable std::vector<double> jacobian_;  ///< by columns, m x n
  double time_ = 0.0;
};

}  // namespace tandem::mbs
