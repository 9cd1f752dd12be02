// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/limited_memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace tandem::cli {

#ifdef __linux__
namespace {

bool is_limited(decltype(RLIMIT_AS) what) {
  struct rlimit limit {};
  return ::getrlimit(what, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace
#endif

void begin_anew_if_limited(char** argv) {
#ifdef __linux__
  constexpr const char *threads = "OPENBLAS_NUM_THREADS", *one = "1";
  if (!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA)) return;
  const char* now = std::getenv(threads);
  if (now && std::strcmp(now, one) == 0) return;
  if (::setenv(threads, one, 1) == 0) ::execv("/proc/self/exe", argv);
#else
  static_cast<void>(argv);
#endif
}

}  // namespace tandem::cli
