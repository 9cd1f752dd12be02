// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/files_read.hpp"

namespace tandem {

static thread_local FilesRead* newest = nullptr;

FilesRead::FilesRead() : before_(newest) { newest = this; }
FilesRead::~FilesRead() { newest = before_; }

void FilesRead::note(const std::filesystem::path& file) {
  if (newest) newest->files_.insert(std::filesystem::absolute(file));
}

}  // namespace tandem
