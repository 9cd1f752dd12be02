// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "tandem/subsystem.hpp"

namespace tandem {

/// An output follows this input at once.
inline bool feeds(const SubsystemInfo& info, int input) {
  return std::any_of(info.feedthrough.begin(), info.feedthrough.end(),
                     [input](const Feedthrough& f) { return f.input == input; });
}

/// This output follows an input at once.
inline bool follows(const SubsystemInfo& info, int output) {
  return std::any_of(info.feedthrough.begin(), info.feedthrough.end(),
                     [output](const Feedthrough& f) { return f.output == output; });
}

}  // namespace tandem
