// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/profile.hpp"

#include <chrono>

#include "tandem/error.hpp"
#include "timed.hpp"

namespace tandem::mbs {

const std::array<const char*, task_count> task_names = {"update",
                                                        "dynamic terms",
                                                        "tangent",
                                                        "residual",
                                                        "factorization",
                                                        "substitution",
                                                        "velocity projection",
                                                        "acceleration projection"};

#ifdef TANDEM_PROFILE
namespace {
thread_local std::array<double, task_count> seconds{};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}  // namespace

Timed::Timed(Task task) : task_(task), began_(now()) {}
Timed::~Timed() { seconds[static_cast<std::size_t>(task_)] += now() - began_; }

const std::array<double, task_count>& profile() { return seconds; }
void clear_profile() { seconds.fill(0.0); }
#else
namespace {
[[noreturn]] void refuse_without_profile() {
  throw Error(ErrorCode::not_supported,
              "this tandem was built without -DTANDEM_PROFILE=ON, so steps are not timed");
}
}  // namespace

const std::array<double, task_count>& profile() { refuse_without_profile(); }
void clear_profile() { refuse_without_profile(); }
#endif

}  // namespace tandem::mbs
