// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include "tandem/sources/view_table.hpp"

namespace tandem::view {

/// What the page draws of a mechanism, beside where its points are: `entities` (name, whether a point, fixed,
/// as drawn), and by their indices rods (bodies of two points), links (distances), plates (bodies of more,
/// and blocks for those of one), masses, springs, wheels, rails; `up`, or null without gravity; what the
/// table [view] says. A place is the index of a point, or { constant, terms }, the constant plus the sum of
/// along times an entity and across times the entity turned by a quarter (terms: entity, along, across).
nlohmann::ordered_json drawing(const mbs::Description& in, const ViewTable& view);

}  // namespace tandem::view
