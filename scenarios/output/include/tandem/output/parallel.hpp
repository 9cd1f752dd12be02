// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>

namespace tandem::output {

/// Calls work(i) for i from 0 to count - 1 on so many threads, or as many as the system gives. The calling
/// thread calls tick(done) now and then, and at the end; if it returns false no more work is begun. What work
/// throws is thrown on, after what else is at hand.
void for_each_in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                          const std::function<bool(std::size_t)>& tick);

}  // namespace tandem::output
