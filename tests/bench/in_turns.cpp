// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/in_turns.hpp"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>

namespace tandem::bench {
namespace {

constexpr int turn = 50, warming = 5;  // exchanges

double seconds_of(const std::function<void()>& exchange, int batch) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  for (int k = 0; k < batch; ++k) exchange();
  return std::chrono::duration<double>(Clock::now() - begin).count() / batch;
}

void take_turn(const std::function<void()>& exchange, int batch, std::vector<double>& seconds) {
  for (int k = 0; k < warming; ++k) exchange();
  for (int k = 0; k < turn; ++k) seconds.push_back(seconds_of(exchange, batch));
}

RoundTrip summary(std::vector<double>& seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
  };
  return {at(0.5), at(0.99)};
}

}  // namespace

Places places() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  ::sched_getaffinity(0, sizeof allowed, &allowed);
  std::vector<int> found;
  for (int k = 0; k < CPU_SETSIZE && found.size() < 2; ++k)
    if (CPU_ISSET(k, &allowed)) found.push_back(k);
  return found.empty() ? Places{0, 0} : Places{found.front(), found.back()};
}

void pin(int processor) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(processor, &one);
  ::sched_setaffinity(0, sizeof one, &one);  // of this thread; where it is refused the system chooses
}

InTurns measure_in_turns(const std::function<void()>& tandem, const std::function<void()>& raw, int count,
                         int batch) {
  std::vector<double> ours, theirs;
  std::exception_ptr failure;
  const int here = places().here;
  std::thread([&] {
    try {
      pin(here);
      while (static_cast<int>(ours.size()) < count) {
        take_turn(tandem, batch, ours);
        take_turn(raw, batch, theirs);
      }
    } catch (...) {
      failure = std::current_exception();
    }
  }).join();
  if (failure) std::rethrow_exception(failure);
  return {summary(ours), summary(theirs)};
}

}  // namespace tandem::bench
