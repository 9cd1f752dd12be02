// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as an FMU's description: one whose ports and settings make sense, or an Error.
#include <cstdint>

#include "ports.hpp"
#include "settings.hpp"
#include "tandem/check_info.hpp"
#include "tandem/error.hpp"
#include "tandem/fmi/description.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    using namespace tandem::fmi;
    Description d = read_description(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
    tandem::Parameters p;
    p.set("step", 0.1);
    const Settings settings = take_settings(d, p, {});
    tandem::check_info("fuzz", ports_of(d, settings).info);
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
