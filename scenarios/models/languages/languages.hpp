// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>

#include "tandem/text/keys.hpp"

namespace tandem::scenario {

/// The languages of files, by their names: diagram, mechanism, scenario; with the elements and the kinds of
/// blocks that this program has.
const std::map<std::string, text::Keys>& languages();

}  // namespace tandem::scenario
