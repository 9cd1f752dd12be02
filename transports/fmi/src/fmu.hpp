// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "log.hpp"
#include "ports.hpp"
#include "settings.hpp"
#include "tandem/fmi/archive.hpp"
#include "tandem/fmi/description.hpp"

namespace tandem::fmi {

/// An FMU's file and what is to be made of it; nothing of it has been loaded.
struct Fmu {
  std::filesystem::path file;
  std::unique_ptr<Archive> archive;
  Description description;
  Settings settings;
  Ports ports;
};

/// Reads it. Throws Error that names the file.
Fmu read_fmu(const std::filesystem::path& file, Parameters& parameters, const FmuIntegrators& integrators);

/// The folder below binaries/ for this processor and Linux; empty where the version names none.
std::string platform(Version version);
/// The library's name in the archive.
std::string library_of(const Fmu& fmu);

}  // namespace tandem::fmi
