// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/limited_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

namespace tandem::cli {

void begin_anew_if_limited(char** argv) {
#ifdef __linux__
  constexpr const char* threads = "OPENBLAS_NUM_THREADS";
  struct rlimit addresses {};
  if (::getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur == RLIM_INFINITY) return;
  if (!std::getenv(threads) && ::setenv(threads, "1", 0) == 0) ::execv("/proc/self/exe", argv);
#else
  static_cast<void>(argv);
#endif
}

}  // namespace tandem::cli
