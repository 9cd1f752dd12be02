// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "view/run.hpp"
#include "view/thinning.hpp"

namespace tandem::view {

/// What a page is made of.
struct Content {
  std::vector<Run> runs;  ///< the result, and one that it is laid over
  int every = 0;          ///< of each so many rows one is kept, and the last; 0: what a page can show
  std::vector<std::string> notes;
};

/// The rows of a table that the page has.
Thinning thinning_of(const text::TimeTable& table, int every);

/// The data of a page: title, plots, and of each run its label, status, columns with units and drawings.
/// Numbers are in base64: of eight bytes, or of four for positions that only the drawing needs.
nlohmann::ordered_json data_of(const Content& content);

}  // namespace tandem::view
