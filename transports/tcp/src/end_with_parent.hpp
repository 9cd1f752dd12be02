// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

namespace tandem::tcp {

/// Called in a child process between fork and exec: the system is to end it when the thread that made it is
/// gone. Where the system has no such thing, nothing is done: a program that reads its socket sees the end.
void end_with_parent(pid_t parent) noexcept;

}  // namespace tandem::tcp
