// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>

namespace tandem::bench {

/// Bytes that the program holds of the heap at this moment, as glibc counts them (mallinfo2), its own records
/// included; nothing with another C library.
std::optional<std::size_t> heap_bytes();

}  // namespace tandem::bench
