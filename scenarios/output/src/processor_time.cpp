// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/processor_time.hpp"

#include <time.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace tandem::output {
namespace {

namespace fs = std::filesystem;

double read(clockid_t clock) {
  timespec now{};
  if (::clock_gettime(clock, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds those that `process` has started, and these. Each thread's children stand in a file of its own.
void add_descendants(pid_t process, std::vector<pid_t>& to) {
  std::error_code gone;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(process) + "/task", gone)) {
    std::ifstream children(thread.path() / "children");
    for (pid_t child = 0; children >> child;) {
      to.push_back(child);
      add_descendants(child, to);
    }
  }
}

}  // namespace

double processor_time() {
  std::vector<pid_t> others;
  add_descendants(::getpid(), others);
  double sum = read(CLOCK_PROCESS_CPUTIME_ID);
  for (const pid_t other : others)
    if (clockid_t clock{}; ::clock_getcpuclockid(other, &clock) == 0) sum += read(clock);
  return sum;
}

}  // namespace tandem::output
