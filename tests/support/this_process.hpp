// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

// What Linux tells of the process that asks.
namespace tandem::test {

inline std::ptrdiff_t entries_of_this_process(const char* kind) {
  return std::distance(std::filesystem::directory_iterator(std::filesystem::path("/proc/self") / kind), {});
}
inline std::ptrdiff_t open_files() { return entries_of_this_process("fd"); }
inline std::ptrdiff_t running_threads() { return entries_of_this_process("task"); }

/// Bytes that are in the machine's memory.
inline std::int64_t resident() {
  std::int64_t all = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> all >> pages;
  return pages * ::sysconf(_SC_PAGESIZE);
}

}  // namespace tandem::test
