// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/platform.hpp"

namespace tandem::fmi {
namespace {

/// Of 2.0 the standard names those of Intel processors alone.
std::string folder_of(Version version) {
#if defined(__x86_64__)
  return version == Version::two ? "linux64" : "x86_64-linux";
#elif defined(__i386__)
  return version == Version::two ? "linux32" : "x86-linux";
#elif defined(__aarch64__)
  return version == Version::two ? "" : "aarch64-linux";
#else
  return "";
#endif
}

}  // namespace

std::string binaries_of_this_platform(Version version) {
  const std::string folder = folder_of(version);
  return folder.empty() ? "" : "binaries/" + folder + "/";
}

}  // namespace tandem::fmi
