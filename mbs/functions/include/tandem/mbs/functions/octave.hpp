// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "tandem/mbs/functions/functions.hpp"

namespace tandem::mbs {

struct OctaveSettings {
  std::string command = "octave-cli";  ///< the program, looked for in PATH
  double deadline = 10.0;              ///< [s] for each answer, the first with the start of Octave in it
};

/// The functions of an Octave file, evaluated by an Octave process: commands go to it as text, and values
/// come back as text of 17 digits. The file holds a function of its own name without arguments, which gives a
/// struct as OctaveStruct wants it. Throws Error, also from evaluate(): Octave can't be started, has ended,
/// does not answer in time (it is then killed, as it is with this object); an error in the file, with
/// Octave's own message.
std::unique_ptr<Functions> open_octave(const std::filesystem::path& file,
                                       const OctaveSettings& settings = {});

}  // namespace tandem::mbs
