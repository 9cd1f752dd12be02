// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>

#include "tandem/scenario/file_text.hpp"
#include "tandem/text/document.hpp"

namespace tandem::scenario {

/// Throws Error as file_text() does, and for what is not TOML.
inline text::Document document_of(const std::filesystem::path& file) {
  FileText all = file_text(file);
  return {file.string(), all.text, std::move(all.lines)};
}

}  // namespace tandem::scenario
