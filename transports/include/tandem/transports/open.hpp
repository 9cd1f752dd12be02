// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "tandem/subsystem.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// Makes a subsystem from its parameters.
using Builder = std::function<std::unique_ptr<Subsystem>(Parameters&)>;
/// What "builtin:NAME" can name. Whoever owns the models fills it; transports know none.
using Builtins = std::map<std::string, Builder>;

/// The subsystem that a URI names: "builtin:NAME" or "builtin:NAME?key=value&key=value". Values in the URI
/// stand beside `parameters`; the same one in both is an error. Throws Error for an unknown scheme or name,
/// and for parameters that the subsystem does not take.
std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Parameters parameters = {});

}  // namespace tandem
