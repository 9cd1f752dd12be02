// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "tandem/transports/open.hpp"

namespace tandem::scenario {

struct SourceSettings {
  bool allow_plaintext = false;                       ///< tcp:// and zmq: without keys, beyond this machine
  std::function<void(const std::string&)> tell = {};  ///< takes what the limits of a model tell
};

/// The sources that any scenario may name: files of mechanisms and diagrams, models of functions, shared
/// libraries, and the sockets that this build has. Who has models of its own adds them under
/// Builtins::models, by their NAME in "builtin:NAME"; who offers processes of their own (`isolate`) sets
/// Builtins::server.
Builtins sources(const SourceSettings& settings = {});

}  // namespace tandem::scenario
