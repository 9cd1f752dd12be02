// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "loading.hpp"

#include "tandem/error.hpp"

namespace tandem {

std::string library_named(const std::filesystem::path& file) { return "library '" + file.string() + "'"; }

boost::dll::shared_library load_library(const std::filesystem::path& file,
                                        const std::filesystem::path& from) {
  namespace load_mode = boost::dll::load_mode;
  if (!std::filesystem::exists(file))
    throw Error(ErrorCode::input_output, library_named(file) + " is not there");
  try {
    return boost::dll::shared_library(from, load_mode::rtld_now | load_mode::rtld_local);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::input_output, library_named(file) + " can't be loaded: " + error.what());
  }
}

}  // namespace tandem
