// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/heap.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tandem::bench {
namespace {

/// Of pages and of small pieces: glibc takes large blocks from the system (hblkhd), small ones from its
/// arenas (uordblks), with at most two words more for each.
TEST(Heap, CountsWhatIsAllocatedAndForgetsWhatIsFreed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers have an allocator of their own";
#endif
  const auto before = heap_bytes();
  if (!before) GTEST_SKIP() << "not glibc";
  {
    const std::vector<char> large(10'000'000);
    EXPECT_GE(*heap_bytes(), *before + 10'000'000);
    EXPECT_LE(*heap_bytes(), *before + 10'010'000);
    std::vector<std::vector<char>> small(1000);
    const auto between = *heap_bytes();
    for (auto& piece : small) piece.resize(64);
    EXPECT_GE(*heap_bytes(), between + 64'000);
    EXPECT_LE(*heap_bytes(), between + 80'000);
  }
  EXPECT_LE(*heap_bytes(), *before + 1'000);
}

}  // namespace
}  // namespace tandem::bench
