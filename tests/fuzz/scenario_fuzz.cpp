// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as a scenario's file: a scenario, or an Error.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "tandem/error.hpp"
#include "tandem/scenario/scenario.hpp"

namespace {

/// A file in memory, written anew for each text.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {}
  void write(const std::uint8_t* data, std::size_t size) const {
    if (::ftruncate(descriptor_, 0) != 0 ||
        ::pwrite(descriptor_, data, size, 0) != static_cast<ssize_t>(size))
      std::abort();
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MemoryFile file;
  file.write(data, size);
  try {
    tandem::scenario::read(file.path());
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
