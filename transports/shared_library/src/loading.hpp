// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#define BOOST_DLL_USE_STD_FS 1
#include <boost/dll/shared_library.hpp>
#include <filesystem>
#include <string>
#include <utility>

namespace tandem {

/// "library 'FILE'".
std::string library_named(const std::filesystem::path& file);
/// Throws Error(input_output) that names it.
void require_library(const std::filesystem::path& file);
/// The whole of it at once: a symbol that it lacks is told here, not in the middle of a run. Throws
/// Error(input_output) that names `file`, of which `from` may be a copy or a part. `how`: beside what is
/// always.
boost::dll::shared_library load_library(
    const std::filesystem::path& file, const std::filesystem::path& from,
    boost::dll::load_mode::type how = boost::dll::load_mode::default_mode);

/// A library that goes with its owner, unless one has made a fault.
class LoadedLibrary {
 public:
  explicit LoadedLibrary(boost::dll::shared_library library) : library_(std::move(library)) {}
  ~LoadedLibrary();
  LoadedLibrary(const LoadedLibrary&) = delete;
  LoadedLibrary& operator=(const LoadedLibrary&) = delete;
  const boost::dll::shared_library& get() const { return library_; }

 private:
  boost::dll::shared_library library_;
};

}  // namespace tandem
