/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Preloaded: makes one call of a kind fail, as the system would. TANDEM_FAIL=KIND:NUMBER names it, counted
 * from main() on, or between two signals SIGUSR2 with TANDEM_FAIL_ON_SIGNAL set; the counts are written to
 * the file TANDEM_FAIL_COUNTS then. Kinds: new (memory of C++), thread, descriptor, read, write. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

enum kind { of_new, of_thread, of_descriptor, of_read, of_write, kinds };
static const char* const names[kinds] = {"new", "thread", "descriptor", "read", "write"};
static atomic_long counts[kinds];
static atomic_int armed, written;
static int failing_kind = -1;
static long failing_number;

static void* next_of(const char* name) { return dlsym(RTLD_NEXT, name); }

/* Whether this call is the one. */
static int fails(enum kind kind) {
  if (!atomic_load(&armed)) return 0;
  const long number = atomic_fetch_add(&counts[kind], 1);
  return (int)kind == failing_kind && number == failing_number;
}

static void write_counts(void);
/* Begins to count, and ends: each with a file, which whoever sent the signal waits for. */
static void on_signal(int number) {
  (void)number;
  if (atomic_load(&armed)) {
    write_counts();
    return;
  }
  const char* file = getenv("TANDEM_FAIL_COUNTING");
  FILE* out = file ? fopen(file, "w") : NULL;
  if (out) fclose(out);
  atomic_store(&armed, 1);
}

static void write_counts(void) {
  atomic_store(&armed, 0);
  if (atomic_exchange(&written, 1)) return;
  const char* file = getenv("TANDEM_FAIL_COUNTS");
  if (!file) return;
  FILE* out = fopen(file, "w");
  for (int k = 0; out && k < kinds; ++k) fprintf(out, "%s %ld\n", names[k], atomic_load(&counts[k]));
  if (out) fclose(out);
}

/* Where the program itself is: the first object of all. */
static const char *program_begin, *program_end;
static int find_program(struct dl_phdr_info* info, size_t size, void* unused) {
  (void)size, (void)unused;
  for (int k = 0; k < info->dlpi_phnum; ++k) {
    const ElfW(Phdr)* part = &info->dlpi_phdr[k];
    if (part->p_type != PT_LOAD || !(part->p_flags & PF_X)) continue;
    program_begin = (const char*)(info->dlpi_addr + part->p_vaddr);
    program_end = program_begin + part->p_memsz;
  }
  return 1; /* the first one is the program */
}
static int of_program(const void* caller) {
  return (const char*)caller >= program_begin && (const char*)caller < program_end;
}
static void set_up(void) {
  const char* what = getenv("TANDEM_FAIL");
  for (int k = 0; what && k < kinds; ++k) {
    const size_t length = strlen(names[k]);
    if (strncmp(what, names[k], length) != 0 || what[length] != ':') continue;
    failing_kind = k;
    failing_number = atol(what + length + 1);
  }
  dl_iterate_phdr(find_program, NULL);
  unsetenv("LD_PRELOAD"); /* programs that are started are left alone */
  atexit(write_counts);
  if (getenv("TANDEM_FAIL_ON_SIGNAL"))
    signal(SIGUSR2, on_signal);
  else
    atomic_store(&armed, 1);
}

static int (*real_main)(int, char**, char**);
static int main_from_here(int argc, char** argv, char** environment) {
  set_up();
  return real_main(argc, argv, environment);
}
int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end) {
  int (*real)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void), void (*)(void),
              void*) = (int (*)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void),
                                void (*)(void), void*))next_of("__libc_start_main");
  real_main = main;
  return real(main_from_here, argc, argv, init, fini, rtld_fini, stack_end);
}

/* Memory: operator new, whose failure is std::bad_alloc: the real one is asked for more than there is. */
#define OPERATOR_NEW(symbol, parameters, call, too_much)    \
  void* symbol parameters {                                 \
    static void*(*real)parameters;                          \
    if (!real) real = (void*(*)parameters)next_of(#symbol); \
    return fails(of_new) ? real too_much : real call;       \
  }
static const size_t no_machine_has = (size_t)1 << 62;
OPERATOR_NEW(_Znwm, (size_t size), (size), (no_machine_has))
OPERATOR_NEW(_Znam, (size_t size), (size), (no_machine_has))
OPERATOR_NEW(_ZnwmSt11align_val_t, (size_t size, size_t a), (size, a), (no_machine_has, a))
OPERATOR_NEW(_ZnwmRKSt9nothrow_t, (size_t size, const void* n), (size, n), (no_machine_has, n))

/* Memory that the program itself asks of C, as Eigen's headers do in it; what libraries ask is theirs. */
extern void* __libc_malloc(size_t);
extern void* __libc_realloc(void*, size_t);
void* malloc(size_t size) {
  if (of_program(__builtin_return_address(0)) && fails(of_new)) return NULL;
  return __libc_malloc(size);
}
void* realloc(void* old, size_t size) {
  if (of_program(__builtin_return_address(0)) && fails(of_new)) return NULL;
  return __libc_realloc(old, size);
}

#define FAIL(kind, error, call, value) \
  do {                                 \
    if (fails(kind)) {                 \
      errno = error;                   \
      return value;                    \
    }                                  \
    return call;                       \
  } while (0)
#define REAL(type, name, parameters) \
  static type(*real) parameters;     \
  if (!real) real = (type(*) parameters)next_of(#name)

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  REAL(int, pthread_create, (pthread_t*, const pthread_attr_t*, void* (*)(void*), void*));
  return fails(of_thread) ? EAGAIN : real(thread, attributes, run, argument);
}

static mode_t mode_of(int flags, va_list more) {
  return flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, mode_t) : 0;
}
#define OPEN(name)                                            \
  int name(const char* path, int flags, ...) {                \
    REAL(int, name, (const char*, int, ...));                 \
    va_list more;                                             \
    va_start(more, flags);                                    \
    const mode_t mode = mode_of(flags, more);                 \
    va_end(more);                                             \
    FAIL(of_descriptor, EMFILE, real(path, flags, mode), -1); \
  }
OPEN(open)
OPEN(open64)
int mkstemp(char* name) {
  REAL(int, mkstemp, (char*));
  FAIL(of_descriptor, EMFILE, real(name), -1);
}
FILE* fopen(const char* path, const char* mode) {
  REAL(FILE*, fopen, (const char*, const char*));
  FAIL(of_descriptor, EMFILE, real(path, mode), NULL);
}
FILE* fopen64(const char* path, const char* mode) {
  REAL(FILE*, fopen64, (const char*, const char*));
  FAIL(of_descriptor, EMFILE, real(path, mode), NULL);
}
int socket(int domain, int type, int protocol) {
  REAL(int, socket, (int, int, int));
  FAIL(of_descriptor, EMFILE, real(domain, type, protocol), -1);
}
int socketpair(int domain, int type, int protocol, int ends[2]) {
  REAL(int, socketpair, (int, int, int, int*));
  FAIL(of_descriptor, EMFILE, real(domain, type, protocol, ends), -1);
}
int accept4(int listening, struct sockaddr* from, socklen_t* size, int flags) {
  REAL(int, accept4, (int, struct sockaddr*, socklen_t*, int));
  FAIL(of_descriptor, EMFILE, real(listening, from, size, flags), -1);
}
int pipe2(int ends[2], int flags) {
  REAL(int, pipe2, (int*, int));
  FAIL(of_descriptor, EMFILE, real(ends, flags), -1);
}

ssize_t read(int from, void* to, size_t size) {
  REAL(ssize_t, read, (int, void*, size_t));
  FAIL(of_read, EIO, real(from, to, size), -1);
}
ssize_t recv(int from, void* to, size_t size, int flags) {
  REAL(ssize_t, recv, (int, void*, size_t, int));
  FAIL(of_read, ECONNRESET, real(from, to, size, flags), -1);
}
int poll(struct pollfd* all, nfds_t count, int milliseconds) {
  REAL(int, poll, (struct pollfd*, nfds_t, int));
  FAIL(of_read, ENOMEM, real(all, count, milliseconds), -1);
}

ssize_t write(int to, const void* from, size_t size) {
  REAL(ssize_t, write, (int, const void*, size_t));
  FAIL(of_write, ENOSPC, real(to, from, size), -1);
}
ssize_t writev(int to, const struct iovec* parts, int count) {
  REAL(ssize_t, writev, (int, const struct iovec*, int));
  FAIL(of_write, ENOSPC, real(to, parts, count), -1);
}
ssize_t send(int to, const void* from, size_t size, int flags) {
  REAL(ssize_t, send, (int, const void*, size_t, int));
  FAIL(of_write, EPIPE, real(to, from, size, flags), -1);
}
int fsync(int file) {
  REAL(int, fsync, (int));
  FAIL(of_write, EIO, real(file), -1);
}
int rename(const char* from, const char* to) {
  REAL(int, rename, (const char*, const char*));
  FAIL(of_write, EIO, real(from, to), -1);
}
int ftruncate(int file, off_t size) {
  REAL(int, ftruncate, (int, off_t));
  FAIL(of_write, EIO, real(file, size), -1);
}
int ftruncate64(int file, off64_t size) {
  REAL(int, ftruncate64, (int, off64_t));
  FAIL(of_write, EIO, real(file, size), -1);
}
int mkdir(const char* path, mode_t mode) {
  REAL(int, mkdir, (const char*, mode_t));
  FAIL(of_write, EACCES, real(path, mode), -1);
}
