// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace tandem::mbs {

/// While it lives, denormal numbers (below 2.2e-308, of which each operation may take a hundred times as
/// long) count as zero: damped motions end in them. Processors without SSE2 are left as they are.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero | denormals_are_zero); }
  ~FlushDenormals() { _mm_setcsr((_mm_getcsr() & ~both) | (before_ & both)); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE2__)
 private:
  static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040,
                            both = flush_to_zero | denormals_are_zero;
  unsigned before_;
#endif
};

}  // namespace tandem::mbs
