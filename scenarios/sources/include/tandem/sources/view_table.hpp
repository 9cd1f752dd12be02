// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/description.hpp"
#include "tandem/text/document.hpp"

namespace tandem {

/// The table [view] of a mechanism's file: what `tandem view` can't see in the equations.
struct ViewTable {
  /// A circle about a point.
  struct Wheel {
    int centre;              ///< A point.
    mbs::Edge axis = {};     ///< In space; in the plane it is the third direction.
    double radius, width;    ///< [m].
    mbs::Edge spoke = {};    ///< Turns with it, across the axis; `to` is -1 if none is given.
    std::string angle = {};  ///< Or: the output that it turns by [rad], from where it stands as drawn.
  };
  std::vector<Wheel> wheels;
  std::optional<double> ground;    ///< its height against gravity [m]
  int follow = -1;                 ///< the point that the view moves with; -1: none is given
  std::vector<int> trace;          ///< points whose paths are drawn
  std::vector<std::string> plots;  ///< outputs that are plotted at first
};

/// Throws Error with file, line, the value found and what is allowed. Without the table: an empty one.
ViewTable read_view(const text::Document& document, const mbs::Description& description);

}  // namespace tandem
