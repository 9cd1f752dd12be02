// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/parallel.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "tandem/error.hpp"

namespace tandem::output {
namespace {

/// As many as the system gives: fewer do the same work.
template <class Run>
void begin(std::vector<std::jthread>& pool, unsigned threads, const Run& run) {
  pool.reserve(threads);
  try {
    while (pool.size() < threads) pool.emplace_back(run);
  } catch (const std::exception&) {
    if (pool.empty()) throw Error(ErrorCode::internal, "not one thread can be started");
  }
}

}  // namespace

void for_each_in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                          const std::function<bool(std::size_t)>& tick) {
  std::atomic<std::size_t> next{0}, done{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    try {
      for (std::size_t i; !stop && (i = next++) < count; ++done) work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      stop = true;
    }
  };
  {
    std::vector<std::jthread> pool;
    try {
      begin(pool, threads, run);
      while (!stop && done < count) {
        if (!tick(done)) stop = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    } catch (...) {
      stop = true;
      throw;
    }
  }
  if (failure) std::rethrow_exception(failure);
  tick(done);
}

}  // namespace tandem::output
