// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "tandem/scenario/assembly.hpp"

namespace tandem::scenario {

class Estimate;

/// A run between two rounds as a file: 8 bytes "TANDEMCP", u32 format version, u64 length and u64 checksum of
/// what follows. That is a text, what it is a checkpoint of (identity()); Coordinator::save; Indicators::save and
/// Estimate::save, if there are any; Recorder::save.
class Checkpoint {
 public:
  static constexpr std::uint32_t format_version = 9;

  /// Null for those that are not there.
  struct Watching {
    Indicators* indicators = nullptr;
    Estimate* estimate = nullptr;
  };

  /// All must outlive it.
  Checkpoint(const Scenario& scenario, const Builtins& builtins, Assembly& assembly, Recorder& recorder,
             Watching watching);

  /// With the recorded rows, down to the disk; an earlier file stays until the new one is whole. Throws
  /// Error(input_output) with the path, and what a subsystem throws.
  void write(const std::filesystem::path& file);

  /// What coordination.scheme = "auto" took for the run that wrote a file. Throws Error as resume does.
  static std::vector<std::string> taken(const std::filesystem::path& file);

  /// After Assembly::initialize, in place of the first samples: the run stands where the file was written.
  /// Throws Error with the path for a file that is not there, is none, is of another format version,
  /// truncated, damaged, or of another run, with the first difference.
  void resume(const std::filesystem::path& file);

 private:
  std::string identity() const;  ///< JSON
  void check_identity(const std::string& text, const std::filesystem::path& file) const;

  const Scenario& scenario_;
  const Builtins& builtins_;
  Assembly& assembly_;
  Recorder& recorder_;
  Watching watching_;
};

}  // namespace tandem::scenario
