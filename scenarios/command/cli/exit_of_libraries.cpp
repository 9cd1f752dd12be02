// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// exit() and _exit() of the command, which a library that is loaded finds before those of the C library: one
// that ends the program gives no status of its own, and ends the run, not the program, where it can. (A
// sanitizer has an _exit() already.)
#include <dlfcn.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tandem/library_file.hpp"

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

extern "C" void _exit(int status) {
  const int own = tandem::LibraryCall::refuse_exit(status);
  for (;;) ::syscall(SYS_exit_group, own);
}

/// Before anything that the C library's does: objects of this program are still there.
extern "C" void exit(int status) noexcept {
  tandem::LibraryCall::return_from_exit();
  reinterpret_cast<void (*)(int)>(::dlsym(RTLD_NEXT, "exit"))(status);
  for (;;) ::_exit(status);
}

extern "C" void _Exit(int status) noexcept { _exit(status); }

#endif
