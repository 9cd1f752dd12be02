// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/declared_parameters.hpp"
#include "tandem/wire/bytes.hpp"

namespace tandem::wire {

/// A name or another short text, to be shown.
std::string read_name(Reader& in);

/// The declaration of parameters. Throws Error(invalid_argument) for one that is not right.
void put_declared(Writer& frame, const DeclaredParameters& declared);
DeclaredParameters read_declared(Reader& in);

}  // namespace tandem::wire
