// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "fmus.hpp"
#include "scratch.hpp"
#include "tandem/export/export.hpp"
#include "tandem/fmi/archive.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::test {

inline Builtins file_sources() {
  Builtins all{{}, {{"diagram", diagram_source()}, {"mechanism", mechanism_source()}}};
  scenario::add_nested(all);
  return all;
}

/// It falls from 1 m, and leaves with 0.7 of its speed.
inline const std::string ball =
    "[blocks]\nv = { kind = 'integrator', input = -9.81, reset = 'below', reset_to = 'up' }\n"
    "up = { kind = 'gain', input = 'v', gain = -0.7 }\nx = { kind = 'integrator', input = 'v', initial = 1 "
    "}\n"
    "below = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = 'm' }\nv = { unit = 'm/s' }\n"
    "[run]\nstep = 0.01\n";

/// FMUs of texts of files, in a folder of their own.
class Exports {
 public:
  /// Of a mechanism, a diagram or a scenario. Its file is NAME.toml, the FMU NAME.fmu.
  std::filesystem::path fmu(const std::string& name, const std::string& text,
                            fmi::Version version = fmi::Version::two,
                            exported::Interface interface = exported::Interface::co_simulation) const {
    return of(folder.write(name + ".toml", text).string(), name, version, interface);
  }
  std::filesystem::path of(const std::string& source, const std::string& name = "x",
                           fmi::Version version = fmi::Version::two,
                           exported::Interface interface = exported::Interface::co_simulation) const {
    const auto file = folder.path() / (name + ".fmu");
    exported::export_fmu({source, {}, file, version, TANDEM_FMU_LIBRARY, {}, interface}, file_sources());
    return file;
  }
  static std::unique_ptr<Subsystem> open(const std::filesystem::path& fmu, const std::string& parameters) {
    return tandem::open("fmu:" + fmu.string() + "?" + parameters, fmu_sources());
  }
  /// The files of an FMU as an importer has them.
  std::filesystem::path unpacked(const std::filesystem::path& fmu) const {
    const auto to = folder.path() / fmu.stem();
    fmi::Archive(fmu).unpack("resources/", to);
    return to / "resources";
  }

  Scratch folder;
};

}  // namespace tandem::test
