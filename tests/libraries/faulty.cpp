// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A library of which every entry breaks the contract in its own way; x' = 0 otherwise, with a step of 0.1 s.
// The file is long, as the ways are many and the entries of one library.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

#include "tandem/subsystem.h"

namespace {

tandem_status create(const char*, void** self) {
  static double time;
  *self = &time;
  return TANDEM_OK;
}
void destroy(void*) {}
const char* last_error(void*) { return nullptr; }
const tandem_info* info(void*) {
  static const tandem_port output = {"x", "m", 1, 0, 0.0};
  static const tandem_info sound = {"faulty", 0, 0, 1, 0, nullptr, &output, nullptr};
  return &sound;
}

void append(tandem_samples* y, double t, double x) {
  double* row = y->rows + y->size++ * y->stride;
  row[0] = t, row[1] = 0.0, row[2] = x;
}
tandem_status initialize(void* self, double t, double, const double*, tandem_samples* y, tandem_clock* c) {
  append(y, *static_cast<double*>(self) = t, 1.0);
  *c = {t, t + 0.1, TANDEM_STOP_LIMIT, 0};
  return TANDEM_OK;
}
tandem_status step(void* self, double h, double x, tandem_samples* y, tandem_clock* c) {
  double& time = *static_cast<double*>(self);
  append(y, time += h, x);
  *c = {time, time + 0.1, TANDEM_STOP_LIMIT, 0};
  return TANDEM_OK;
}
tandem_status advance(void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y,
                      tandem_clock* c) {
  return step(self, 0.1, 1.0, y, c);
}

tandem_subsystem_api sound() {
  tandem_subsystem_api api{};
  api.abi_version = TANDEM_ABI_VERSION;
  api.table_size = sizeof(tandem_subsystem_api);
  api.create = create;
  api.destroy = destroy;
  api.info = info;
  api.last_error = last_error;
  api.initialize = initialize;
  api.advance = advance;
  return api;
}

using Advance = decltype(tandem_subsystem_api::advance);
tandem_subsystem_api with(Advance call) {
  tandem_subsystem_api api = sound();
  api.advance = call;
  return api;
}

}  // namespace

extern "C" {

int counter = 3;
extern const int constant;
const int constant = 3;
thread_local int of_a_thread = 3;

const tandem_subsystem_api* no_table() { return nullptr; }
const tandem_subsystem_api* entry_throws() { throw std::runtime_error("not today"); }

const tandem_subsystem_api* wrong_version() {
  static tandem_subsystem_api api = sound();
  api.abi_version = 99;
  return &api;
}

const tandem_subsystem_api* missing_function() {
  static tandem_subsystem_api api = with(nullptr);
  return &api;
}

const tandem_subsystem_api* garbage_size() {
  static tandem_subsystem_api api = sound();
  api.info = [](void*) -> const tandem_info* {
    static const tandem_port output = {"x", "m", 2'000'000'000, 0, 0.0};
    static const tandem_info garbage = {"faulty", 0, 0, 1, 0, nullptr, &output, nullptr};
    return &garbage;
  };
  return &api;
}

const tandem_subsystem_api* garbage_count() {
  static tandem_subsystem_api api = sound();
  api.info = [](void*) -> const tandem_info* {
    static const tandem_info garbage = {"faulty", 0, -7, 1, 0, nullptr, nullptr, nullptr};
    return &garbage;
  };
  return &api;
}

const tandem_subsystem_api* throws() {
  static const tandem_subsystem_api api =
      with([](void*, double, std::int32_t, const tandem_signal*, tandem_samples*,
              tandem_clock*) -> tandem_status { throw std::runtime_error("no oil"); });
  return &api;
}

const tandem_subsystem_api* aborts() {
  static const tandem_subsystem_api api =
      with([](void*, double, std::int32_t, const tandem_signal*, tandem_samples*,
              tandem_clock*) -> tandem_status { std::abort(); });
  return &api;
}

const tandem_subsystem_api* without_a_fault() {
  static const tandem_subsystem_api api = sound();
  return &api;
}

/// After ten calls that are sound.
tandem_status after_ten(void* self, tandem_samples* y, tandem_clock* c, void (*fault)()) {
  static int calls = 0;
  if (++calls > 10) fault();
  return step(self, 0.1, 1.0, y, c);
}

const tandem_subsystem_api* reaches_for_nothing() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return after_ten(self, y, c, [] { *static_cast<volatile int*>(nullptr) = 1; });
      });
  return &api;
}

/// And closes a pipe that it writes to, which is a signal.
const tandem_subsystem_api* goes_elsewhere() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return after_ten(self, y, c, [] {
          if (::chdir("/") == 0) std::raise(SIGPIPE);
        });
      });
  return &api;
}

/// Its own stack is at its end.
int deeper(volatile int* here) {
  volatile int there[1024] = {*here};
  return deeper(there) + there[7];
}

const tandem_subsystem_api* calls_itself() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return after_ten(self, y, c, [] {
          volatile int first = 1;
          deeper(&first);
        });
      });
  return &api;
}

const tandem_subsystem_api* exits() {
  static const tandem_subsystem_api api =
      with([](void*, double, std::int32_t, const tandem_signal*, tandem_samples*,
              tandem_clock*) -> tandem_status { std::exit(0); });
  return &api;
}

const tandem_subsystem_api* exits_quickly() {
  static const tandem_subsystem_api api =
      with([](void*, double, std::int32_t, const tandem_signal*, tandem_samples*,
              tandem_clock*) -> tandem_status { std::quick_exit(0); });
  return &api;
}

const tandem_subsystem_api* exits_at_once() {
  static const tandem_subsystem_api api =
      with([](void*, double, std::int32_t, const tandem_signal*, tandem_samples*,
              tandem_clock*) -> tandem_status { ::_exit(0); });
  return &api;
}

const tandem_subsystem_api* exits_in_create() {
  static tandem_subsystem_api api = sound();
  api.create = [](const char*, void**) -> tandem_status { std::exit(0); };
  return &api;
}

const tandem_subsystem_api* exits_in_destroy() {
  static tandem_subsystem_api api = sound();
  api.destroy = [](void*) { std::exit(0); };
  return &api;
}

const tandem_subsystem_api* exits_as_entry() { std::exit(0); }

const tandem_subsystem_api* exits_in_a_thread() {
  static const tandem_subsystem_api api = with(
      [](void*, double, std::int32_t, const tandem_signal*, tandem_samples*, tandem_clock*) -> tandem_status {
        std::thread([] { ::_exit(0); }).join();
        return TANDEM_OK;
      });
  return &api;
}

/// In a destructor, when the library is unloaded.
const tandem_subsystem_api* exits_when_unloaded() {
  static const struct Last {
    ~Last() { ::_exit(0); }
  } last;
  static const tandem_subsystem_api api = sound();
  return &api;
}

/// As an abort, which the sanitizers leave alone.
const tandem_subsystem_api* faults_in_a_thread() {
  static const tandem_subsystem_api api = with(
      [](void*, double, std::int32_t, const tandem_signal*, tandem_samples*, tandem_clock*) -> tandem_status {
        std::thread([] { std::abort(); }).join();
        return TANDEM_OK;
      });
  return &api;
}

/// In a thread that nobody waits for.
tandem_status after_ten_beside(void* self, tandem_samples* y, tandem_clock* c, void (*fault)()) {
  static void (*what)() = nullptr;
  what = fault;
  return after_ten(self, y, c, [] {
    std::thread(what).detach();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  });
}

const tandem_subsystem_api* faults_beside() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return after_ten_beside(self, y, c, [] { std::abort(); });
      });
  return &api;
}

const tandem_subsystem_api* exits_beside() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return after_ten_beside(self, y, c, [] { std::exit(0); });
      });
  return &api;
}

const tandem_subsystem_api* faults_when_unloaded() {
  static const struct Last {
    ~Last() { std::abort(); }
  } last;
  static const tandem_subsystem_api api = sound();
  return &api;
}

const tandem_subsystem_api* computes_on() {
  static const tandem_subsystem_api api = with(
      [](void*, double, std::int32_t, const tandem_signal*, tandem_samples*, tandem_clock*) -> tandem_status {
        std::puts("the model computes on");
        std::fflush(stdout);
        std::this_thread::sleep_for(std::chrono::hours(1));
        return TANDEM_OK;
      });
  return &api;
}

/// A process of its own, which may end as it likes.
const tandem_subsystem_api* forks() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        if (::fork() == 0) std::exit(0);
        return step(self, 0.1, 1.0, y, c);
      });
  return &api;
}

const tandem_subsystem_api* creates_nothing() {
  static tandem_subsystem_api api = sound();
  api.create = [](const char*, void** self) {
    *self = nullptr;
    return TANDEM_OK;
  };
  return &api;
}

const tandem_subsystem_api* rewrites() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        if (y->size > 0) y->rows[(y->size - 1) * y->stride + 2] = 7.0;
        return step(self, 0.1, 1.0, y, c);
      });
  return &api;
}

const tandem_subsystem_api* flag_of_a_half() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        const tandem_status status = step(self, 0.1, 1.0, y, c);
        y->rows[(y->size - 1) * y->stride + 1] = 0.5;
        return status;
      });
  return &api;
}

const tandem_subsystem_api* not_a_number() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return step(self, 0.1, std::numeric_limits<double>::quiet_NaN(), y, c);
      });
  return &api;
}

const tandem_subsystem_api* past_the_limit() {
  static const tandem_subsystem_api api =
      with([](void* self, double, std::int32_t, const tandem_signal*, tandem_samples* y, tandem_clock* c) {
        return step(self, 5.0, 1.0, y, c);
      });
  return &api;
}

}  // extern "C"
