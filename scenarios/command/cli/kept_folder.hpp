// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <spdlog/spdlog.h>

#include "tandem/output/lock.hpp"

namespace tandem::cli {

/// A folder that a command writes to, which no other does meanwhile; what there is to note goes to the log.
class KeptFolder : public output::FolderLock {
 public:
  explicit KeptFolder(const std::filesystem::path& folder)
      : FolderLock(folder, [](const std::string& what) { spdlog::warn("note: {}", what); }) {}
};

}  // namespace tandem::cli
