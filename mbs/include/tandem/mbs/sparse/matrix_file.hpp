// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

// Sparse matrices in text files. Numbers are written so that reading gives the same bits. All functions throw
// Error(input_output) with file, line, what was found and what is allowed there.

/// Matrix Market, `coordinate real general` (R. F. Boisvert, R. Pozo, K. Remington, The Matrix Market
/// Exchange Formats, NISTIR 5935, 1996): scipy.io.mmread and Octave's mmread take it.
void write_matrix_market(const std::filesystem::path& file, const Matrix& matrix);

/// Matrix Market, `coordinate`, `real` or `integer`, `general` or `symmetric` (then with both triangles in
/// the result). Entries that are there twice add up, as the format says.
Matrix read_matrix_market(const std::filesystem::path& file);

/// Compressed columns as they are stored, counted from zero, one line each: "rows columns entries", the
/// columns' starts (columns + 1), rows, values. Lines that begin with % are comments.
void write_compressed_columns(const std::filesystem::path& file, const Matrix& matrix);

/// The same. Rows within a column ascend.
Matrix read_compressed_columns(const std::filesystem::path& file);

}  // namespace tandem::mbs
