// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "loading.hpp"

#include "tandem/error.hpp"
#include "tandem/library_file.hpp"

namespace tandem {
namespace {

/// What the system's loader says within what Boost says.
std::string said_by_loader(const std::string& text) {
  const std::string before = "message: ", after = "): ";
  const auto begin = text.find(before), end = text.rfind(after);
  return begin < end && end != std::string::npos
             ? text.substr(begin + before.size(), end - begin - before.size())
             : text;
}

}  // namespace

std::string library_named(const std::filesystem::path& file) { return "library '" + file.string() + "'"; }

void require_library(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw Error(ErrorCode::input_output, library_named(file) + " is not there");
}

boost::dll::shared_library load_library(const std::filesystem::path& file, const std::filesystem::path& from,
                                        boost::dll::load_mode::type how) {
  namespace load_mode = boost::dll::load_mode;
  require_library(from);
  const std::string name = library_named(file);
  check_library_file(from, name);
  LibraryCall::guard_exit();
  LibraryCall beginning(name.c_str());  // of what it does when it is loaded
  try {
    return boost::dll::shared_library(from, load_mode::rtld_now | load_mode::rtld_local | how);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::input_output, name + " can't be loaded: " + said_by_loader(error.what()));
  }
}

LoadedLibrary::~LoadedLibrary() {
  if (LibraryCall::has_faulted()) static_cast<void>(new boost::dll::shared_library(std::move(library_)));
}

}  // namespace tandem
