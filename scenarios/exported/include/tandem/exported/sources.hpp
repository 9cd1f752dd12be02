// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "tandem/transports/open.hpp"

namespace tandem::exported {

/// What an FMU may run: mechanisms and diagrams without kinds of their own, and scenarios of these.
/// - tell: takes sentences on what leaves the limits of a model.
Builtins sources(const std::function<void(const std::string&)>& tell = {});

}  // namespace tandem::exported
