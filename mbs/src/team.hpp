// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

#include "flush_denormals.hpp"

#ifdef TANDEM_OPENMP
#include <omp.h>
#endif

namespace tandem::mbs {

/// While it lives, share() of this thread uses so many threads for loops over `from` elements or more: below
/// some number a loop of 5 to 10 ns an element takes less time than threads need to meet and to fetch each
/// other's results (docs/threads.md).
class Team {
 public:
#ifdef TANDEM_OPENMP
  static constexpr bool can_be_many = true;
#else
  static constexpr bool can_be_many = false;
#endif
  Team(int threads, int from) : size_before_(size_), from_before_(from_) {
    size_ = threads;
    from_ = threads > 1 ? from : alone;
  }
  ~Team() { size_ = size_before_, from_ = from_before_; }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  static int size() { return size_; }
  static int from() { return from_; }

 private:
  static constexpr int alone = std::numeric_limits<int>::max();
  static inline constinit thread_local int size_ = 1, from_ = alone;
  int size_before_, from_before_;
};

/// body(first, last) for parts of 0 .. count, which must not depend on each other and must not throw.
template <class Body>
void share(int count, const Body& body) {
#ifdef TANDEM_OPENMP
  if (count >= Team::from()) {
#pragma omp parallel num_threads(Team::size())
    {
      const FlushDenormals scope;  // each thread has a setting of its own
      const long part = omp_get_thread_num(), parts = omp_get_num_threads();
      const Body own(body);
      own(static_cast<int>(count * part / parts), static_cast<int>(count * (part + 1) / parts));
    }
    return;
  }
#endif
  const Body own(body);  // of whose variables the compiler knows that no thread changes them
  own(0, count);
}

}  // namespace tandem::mbs
