// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as a mechanism's file: a description, or an Error.
#include <cstdint>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    tandem::mbs::read_mechanism("fuzz", std::string(reinterpret_cast<const char*>(data), size));
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
