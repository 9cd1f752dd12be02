// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/this_program.hpp"

#include <filesystem>

namespace tandem {

namespace fs = std::filesystem;

std::string this_program() {
  std::error_code unknown;  // elsewhere than on Linux
  return fs::read_symlink("/proc/self/exe", unknown).string();
}

std::string program_beside(const std::string& name) {
  const fs::path file = fs::path(this_program()).replace_filename(name);
  return fs::exists(file) ? file.string() : "";
}

}  // namespace tandem
