// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "loading.hpp"

#include "tandem/error.hpp"
#include "tandem/library_file.hpp"

namespace tandem {
namespace {

/// In words of the user's, of what the system's loader says.
std::string why_not_loaded(const std::string& said) {
  const auto named = [&](const std::string& before) {
    const auto begin = said.find(before) + before.size();
    return "'" + said.substr(begin, said.find_first_of(":) \n", begin) - begin) + "'";
  };
  const std::string symbol = "undefined symbol: ", needed = "cannot open shared object file";
  if (said.find(symbol) != std::string::npos)
    return "it needs the function " + named(symbol) + ", which neither it nor a library that it names has";
  if (said.find("invalid ELF header") != std::string::npos ||
      said.find("file too short") != std::string::npos || said.find("wrong ELF class") != std::string::npos ||
      said.find("only ET_DYN") != std::string::npos)
    return "it is no shared library of this machine's kind";
  if (said.find(needed) != std::string::npos)
    return "a library that it needs is not found: " + named("message: ");
  return "the system's loader refuses it";
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
    throw Error(ErrorCode::input_output, name + " can't be loaded: " + why_not_loaded(error.what()));
  }
}

LoadedLibrary::~LoadedLibrary() {
  if (LibraryCall::has_faulted()) static_cast<void>(new boost::dll::shared_library(std::move(library_)));
}

}  // namespace tandem
