// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/sparse/tangent.hpp"

namespace tandem::mbs {

/// The matrices of a step where a state stands, to be looked at outside.
struct StepMatrices {
  Matrix mass, jacobian, stiffness, damping;  ///< M, Phi_q (m x n), K, C
  /// M + damping C + stiffness K + penalty (P Phi_q)^T P Phi_q, P the scales of constraints: of a model that
  /// has some, steppers factorize it with rows and columns divided by the scales of coordinates.
  Matrix tangent;
};
StepMatrices step_matrices(Model& model, const State& at, const TangentFactors& factors);

enum class MatrixFormat { matrix_market, compressed_columns };
/// "mtx" or "ccs". Throws Error(invalid_argument) for another name.
MatrixFormat matrix_format(const std::string& name);

/// mass_LABEL.mtx, jacobian_LABEL.mtx and so on, or .ccs. Makes the folder. Throws Error(input_output).
void write(const StepMatrices& matrices, const std::filesystem::path& folder, const std::string& label,
           MatrixFormat format);

}  // namespace tandem::mbs
