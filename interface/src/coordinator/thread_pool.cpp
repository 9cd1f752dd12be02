// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/thread_pool.hpp"

#include <bit>
#include <cstddef>
#include <utility>

namespace tandem {

namespace {
constexpr int looks = 400;  // for work, before a thread sleeps: some 100 us
constexpr int nothing = -1, end = -2;
}  // namespace

ThreadPool::ThreadPool(int threads, int pieces, std::function<void(int)> work)
    : work_(std::move(work)),
      flags_(std::make_unique<Flag[]>(static_cast<std::size_t>(pieces))),
      ring_(std::bit_ceil(static_cast<std::size_t>(pieces + threads))),
      mask_(static_cast<unsigned>(ring_.size()) - 1) {
  try {
    for (int k = 1; k < threads; ++k) threads_.emplace_back([this] { work_on(); });
  } catch (...) {
    send_home();
    throw;
  }
}

ThreadPool::~ThreadPool() { send_home(); }

/// Each thread that there is ends.
void ThreadPool::send_home() {
  for (std::size_t k = 0; k < threads_.size(); ++k) publish(end);
}

void ThreadPool::publish(int piece) {
  const unsigned place = published_.load(std::memory_order_relaxed);
  ring_[place & mask_] = piece;
  published_.store(place + 1, std::memory_order_release);
  published_.notify_one();
}

void ThreadPool::offer(int piece) {
  flags_[static_cast<std::size_t>(piece)].made.store(false, std::memory_order_relaxed);
  if (kept_ >= 0) publish(kept_);
  kept_ = piece;
}

void ThreadPool::finish(int piece) {
  const std::atomic<bool>& made = flags_[static_cast<std::size_t>(piece)].made;
  while (!made.load(std::memory_order_acquire))
    if (kept_ >= 0)
      make(std::exchange(kept_, -1));
    else if (const int other = take(); other >= 0)
      make(other);
    else
      std::this_thread::yield();
}

void ThreadPool::make(int piece) {
  work_(piece);
  flags_[static_cast<std::size_t>(piece)].made.store(true, std::memory_order_release);
}

/// The oldest that was published and that nobody has taken; nothing.
int ThreadPool::take() {
  unsigned place = taken_.load(std::memory_order_relaxed);
  while (place != published_.load(std::memory_order_acquire))
    if (taken_.compare_exchange_weak(place, place + 1, std::memory_order_relaxed))
      return ring_[place & mask_];
  return nothing;
}

void ThreadPool::work_on() {
  for (int looked = 0;;) {
    const unsigned known = published_.load(std::memory_order_relaxed);
    const int piece = take();
    if (piece == end) return;
    if (piece >= 0)
      make(piece), looked = 0;
    else if (++looked < looks)
      std::this_thread::yield();
    else
      published_.wait(known, std::memory_order_relaxed);
  }
}

}  // namespace tandem
