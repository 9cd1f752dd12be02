// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an FMU's file: one whose description can be read, or an Error.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

#include "tandem/error.hpp"
#include "tandem/fmi/archive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("fuzz", 0);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) return -1;
  try {
    const tandem::fmi::Archive archive("/proc/self/fd/" + std::to_string(file));
    archive.folders_in("binaries/");
    if (archive.has("modelDescription.xml")) archive.text("modelDescription.xml", 1U << 20);
  } catch (const tandem::Error&) {  // what has to come of bytes that are not right
  }
  return 0;
}
