// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/this_program.hpp"

#include <filesystem>

namespace tandem {

std::string this_program() {
  std::error_code unknown;  // elsewhere than on Linux
  return std::filesystem::read_symlink("/proc/self/exe", unknown).string();
}

}  // namespace tandem
