// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// _exit() of the command, which a library that is loaded finds before that of the C library: one that ends
// the program gives no status of its own. (A sanitizer has an _exit() already.)
#include <sys/syscall.h>
#include <unistd.h>

#include "tandem/library_file.hpp"

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

extern "C" void _exit(int status) {
  const int own = tandem::LibraryCall::refuse_exit(status);
  for (;;) ::syscall(SYS_exit_group, own);
}

extern "C" void _Exit(int status) noexcept { _exit(status); }

#endif
