// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/step_matrices.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/mbs/sparse/matrix_file.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {
namespace {

/// A matrix from entries that add up where they coincide.
class WeightedSum {
 public:
  void add(const Matrix& a, double factor) {
    const auto entries = a.pattern.entries();
    for (std::size_t k = 0; k < entries.size(); ++k) values_[entries[k]] += factor * a.values[k];
  }
  /// factor A^T A.
  void add_square(const Matrix& a, double factor) {
    std::vector<std::vector<std::pair<int, double>>> rows(static_cast<std::size_t>(a.pattern.rows()));
    const auto entries = a.pattern.entries();
    for (std::size_t k = 0; k < entries.size(); ++k)
      rows[entries[k].first].emplace_back(entries[k].second, a.values[k]);
    for (const auto& row : rows)
      for (const auto& [i, x] : row)
        for (const auto& [j, y] : row) values_[{i, j}] += factor * x * y;
  }
  Matrix matrix(int rows, int columns) const {
    std::vector<std::pair<int, int>> entries;
    for (const auto& [entry, value] : values_) entries.push_back(entry);
    Matrix a{Pattern(rows, columns, std::move(entries)), {}};
    for (const auto& entry : a.pattern.entries()) a.values.push_back(values_.at(entry));
    return a;
  }

 private:
  std::map<std::pair<int, int>, double> values_;
};

Matrix transposed(const Pattern& pattern, const std::vector<double>& values) {
  auto entries = pattern.entries();
  for (auto& [row, column] : entries) std::swap(row, column);
  Matrix a{Pattern(pattern.columns(), pattern.rows(), entries), {}};
  for (const auto& [row, column] : a.pattern.entries()) a.values.push_back(values[pattern.find(column, row)]);
  return a;
}

Matrix on(const Pattern& pattern, const std::vector<double>& values) {
  return {pattern, {values.begin(), values.begin() + pattern.size()}};
}

/// Rows by what steppers multiply the constraints with.
Matrix scaled_rows(Matrix a, const std::vector<double>& scales) {
  const auto entries = a.pattern.entries();
  for (std::size_t k = 0; k < entries.size() && !scales.empty(); ++k)
    a.values[k] *= scales[static_cast<std::size_t>(entries[k].first)];
  return a;
}

}  // namespace

StepMatrices step_matrices(Model& model, const State& at, const TangentFactors& factors) {
  const Structure& s = model.structure();
  ModelMatrices values(s);
  Eigen::VectorXd phi(s.constraints);
  model.at_time(at.time);
  model.constraints(at.q.data(), phi.data(), values.jacobian.data());
  if (s.stiffness.size() > 0)
    model.force_derivatives(at.q.data(), at.v.data(), values.stiffness.data(), values.damping.data());
  StepMatrices result{s.mass,
                      transposed(s.jacobian, values.jacobian),
                      on(s.stiffness, values.stiffness),
                      on(s.stiffness, values.damping),
                      {}};
  WeightedSum sum;
  sum.add(result.mass, 1.0);
  sum.add(result.damping, factors.damping);
  sum.add(result.stiffness, factors.stiffness);
  sum.add_square(scaled_rows(result.jacobian, s.constraint_scales), factors.penalty);
  result.tangent = sum.matrix(s.variables, s.variables);
  return result;
}

MatrixFormat matrix_format(const std::string& name) {
  if (name == "mtx") return MatrixFormat::matrix_market;
  if (name == "ccs") return MatrixFormat::compressed_columns;
  throw Error(ErrorCode::invalid_argument, unknown("format of matrices", name, {"mtx", "ccs"}));
}

void write(const StepMatrices& matrices, const std::filesystem::path& folder, const std::string& label,
           MatrixFormat format) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw Error(ErrorCode::input_output,
                fmt::format("folder '{}' can't be made: {}", folder.string(), failed.message()));
  const bool market = format == MatrixFormat::matrix_market;
  const auto put = [&](const char* name, const Matrix& matrix) {
    const auto file = folder / fmt::format("{}_{}.{}", name, label, market ? "mtx" : "ccs");
    market ? write_matrix_market(file, matrix) : write_compressed_columns(file, matrix);
  };
  put("mass", matrices.mass);
  put("jacobian", matrices.jacobian);
  put("stiffness", matrices.stiffness);
  put("damping", matrices.damping);
  put("tangent", matrices.tangent);
}

}  // namespace tandem::mbs
