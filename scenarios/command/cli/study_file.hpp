// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "tandem/study/study.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::cli {

/// A study as the command finds it.
struct StudyFile {
  study::Study study;
  bool standing;                 ///< that of a scenario that has none
  std::filesystem::path folder;  ///< of its tables, unless another is given
};

/// FILE.toml, or scenarios/NAME/study.toml for NAME.
std::filesystem::path study_path(const std::string& name);
/// results/FOLDER, FOLDER the name of the folder that a file lies in.
std::filesystem::path results_of(const std::filesystem::path& file);
/// overrides: of the scenario, if it is the standing study of one. Throws Error for what is wrong with the
/// file. The standing study of a scenario opens its subsystems.
StudyFile read_study(const std::filesystem::path& file, const Builtins& builtins,
                     const std::vector<std::string>& overrides = {}, std::uint64_t seed = 0);

}  // namespace tandem::cli
