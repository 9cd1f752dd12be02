// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as a study's file: tables of rows with metrics and charts, or an Error.
#include <cstdint>

#include "tandem/error.hpp"
#include "tandem/study/study.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    using namespace tandem::study;
    const Study study = read("fuzz.toml", std::string(reinterpret_cast<const char*>(data), size));
    for (const Table& table : study.tables) study.columns_of(table);
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
