// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as a diagram's file: one that is compiled, or an Error.
#include <cstdint>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    using namespace tandem::engine;
    compile(read_diagram("fuzz", std::string(reinterpret_cast<const char*>(data), size)));
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
