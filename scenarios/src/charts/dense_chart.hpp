// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem bench dense` writes.
struct DenseTime {
  std::string library, operation;
  double size, ns;
};

/// Throws Error for a file that is no such table.
std::vector<DenseTime> read_dense_times(const std::filesystem::path& file);

/// Time over size for each library: products, and Cholesky's factorization with one solution. Throws Error if
/// there are no rows.
Picture dense_chart(const std::vector<DenseTime>& times, const std::vector<std::string>& caption);

}  // namespace tandem::charts
