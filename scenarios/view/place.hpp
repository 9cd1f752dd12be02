// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "tandem/mbs/mechanism/description.hpp"

namespace tandem::view {

/// A place of the drawing that moves with some points and vectors, in the form that drawing() has; exact
/// where these are of one rigid body and reach it.
nlohmann::ordered_json place_on(const mbs::Description& in, const std::vector<int>& entities,
                                const Eigen::Vector3d& at);

/// Corners of the block that has a body's mass and inertia, about its centre. Of a body in space.
std::vector<Eigen::Vector3d> block(const mbs::Body& body);

}  // namespace tandem::view
