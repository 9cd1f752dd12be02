// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "blas_threads.hpp"

#include <dlfcn.h>

#include <array>
#include <cstdint>

namespace tandem::mbs::solvers {
namespace {

/// How to ask and tell the BLAS at hand.
struct Threads {
  int (*get)() = [] { return 1; };
  void (*set)(int) = [](int) {};
};

// BLIS counts in integers of 64 bits unless it was configured otherwise.
std::int64_t (*blis_get)() = nullptr;
void (*blis_set)(std::int64_t) = nullptr;

template <class Function>
Function* find(void* program, const char* name) {
  return reinterpret_cast<Function*>(dlsym(program, name));
}

Threads find_threads() {
  void* const program = dlopen(nullptr, RTLD_LAZY);  // with all libraries that it was linked with
  const Threads openblas{find<int()>(program, "openblas_get_num_threads"),
                         find<void(int)>(program, "openblas_set_num_threads")};
  if (openblas.get && openblas.set) return openblas;
  blis_get = find<std::int64_t()>(program, "bli_thread_get_num_threads");
  blis_set = find<void(std::int64_t)>(program, "bli_thread_set_num_threads");
  if (!blis_get || !blis_set) return {};
  return {[] { return static_cast<int>(blis_get()); }, [](int n) { blis_set(n); }};
}

const Threads& threads() {
  static const Threads found = find_threads();
  return found;
}

}  // namespace

OneBlasThread::OneBlasThread() : before_(threads().get()) {
  if (before_ > 1) threads().set(1);
}

OneBlasThread::~OneBlasThread() {
  if (before_ > 1) threads().set(before_);
}

}  // namespace tandem::mbs::solvers
