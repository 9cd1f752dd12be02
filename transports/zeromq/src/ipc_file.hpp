// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::zeromq {

/// Whether something is at "ipc://PATH" that ZeroMQ must not replace, as its bind() would: any file but a
/// socket whose server is gone. False for addresses that are no path.
bool taken(const std::string& address);

}  // namespace tandem::zeromq
