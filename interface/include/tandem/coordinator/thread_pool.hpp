// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace tandem {

/// Threads that share pieces of work with the one that hands them out.
///
/// A piece is a number below `pieces`; work(piece) makes it, and throws nothing. One thread, always the same,
/// offers and finishes; it makes pieces itself while it waits, and keeps the last one that was offered for
/// itself, so that a piece that stands alone never leaves it. Threads without work look for some for a while
/// and sleep then.
class ThreadPool {
 public:
  /// threads: that of the caller included; 2 or more. Throws std::system_error where one can't be started.
  ThreadPool(int threads, int pieces, std::function<void(int)> work);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Each piece at most once until it has been finished.
  void offer(int piece);
  /// Returns when the piece has been made; what it wrote is visible then.
  void finish(int piece);

 private:
  struct alignas(64) Flag {
    std::atomic<bool> made = false;
  };
  void publish(int piece);
  void send_home();
  int take();
  void make(int piece);
  void work_on();

  std::function<void(int)> work_;
  std::unique_ptr<Flag[]> flags_;  ///< by piece
  std::vector<int> ring_;          ///< what was published
  unsigned mask_;
  int kept_ = -1;
  alignas(64) std::atomic<unsigned> published_ = 0, taken_ = 0;  ///< counts; places in the ring
  std::vector<std::jthread> threads_;
};

}  // namespace tandem
