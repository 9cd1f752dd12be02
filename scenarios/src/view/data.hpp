// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "view/run.hpp"

namespace tandem::view {

/// What a page is made of.
struct Content {
  std::vector<Run> runs;  ///< the result, and one that it is laid over
  int every = 1;          ///< of each so many rows one is kept, and the last
  std::vector<std::string> notes;
};

/// Rows that are kept of so many: one of each `every`, and the last.
std::vector<std::size_t> kept(std::size_t rows, int every);

/// The data of a page: title, plots, and of each run its label, status, columns with units and drawings.
/// Numbers are in base64: of eight bytes, or of four for positions that only the drawing needs.
nlohmann::ordered_json data_of(const Content& content);

}  // namespace tandem::view
