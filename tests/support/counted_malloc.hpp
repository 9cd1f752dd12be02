// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Every malloc is counted. Not with sanitizers, which have a malloc of their own, and only with the GNU C
// library, whose malloc can be replaced and still be called: where TANDEM_OWN_MALLOC is 1. To be included by
// one source of a program.
#include <atomic>
#include <cstdint>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TANDEM_OWN_MALLOC 0
#endif
#endif
#if !defined(TANDEM_OWN_MALLOC) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define TANDEM_OWN_MALLOC 1
#endif

#if TANDEM_OWN_MALLOC
namespace tandem::test {

/// How many there were while `counting`, in all threads.
inline std::atomic<bool> counting = false;
inline std::atomic<std::int64_t> allocations = 0;

inline void count_allocation() {
  if (counting.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace tandem::test

// operator new of libstdc++ ends in malloc or aligned_alloc.
extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void* malloc(size_t size) { return tandem::test::count_allocation(), __libc_malloc(size); }
void* calloc(size_t n, size_t size) { return tandem::test::count_allocation(), __libc_calloc(n, size); }
void* realloc(void* p, size_t size) { return tandem::test::count_allocation(), __libc_realloc(p, size); }
void* aligned_alloc(size_t alignment, size_t size) {
  return tandem::test::count_allocation(), __libc_memalign(alignment, size);
}
void* memalign(size_t alignment, size_t size) {
  return tandem::test::count_allocation(), __libc_memalign(alignment, size);
}
int posix_memalign(void** p, size_t alignment, size_t size) noexcept {
  tandem::test::count_allocation();
  *p = __libc_memalign(alignment, size);
  return *p ? 0 : 12;  // ENOMEM
}
}
#endif
