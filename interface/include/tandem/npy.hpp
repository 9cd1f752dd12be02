// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tandem {

// Tables as numpy.save writes them of a structured array: a head, then row after row of 8-byte floating-point
// numbers, the least significant byte first. Source: numpy.lib.format, version 3.0 of the format. numpy.load
// reads such a file, memory-mapped too, and pandas.DataFrame(numpy.load(FILE)) has its columns by name.

/// The head of a table of so many rows. Its size does not depend on their number.
std::string npy_head(const std::vector<std::string>& names, std::uint64_t rows);

struct NpyHead {
  std::vector<std::string> names;
  std::uint64_t rows = 0;
  std::size_t size = 0;  ///< bytes
};
/// Of the first bytes of a file: a head of version 1.0, 2.0 or 3.0. Throws Error(input_output), with why, for
/// what is none, or is one of anything but a table of such numbers.
NpyHead read_npy_head(std::span<const std::byte> bytes);

}  // namespace tandem
