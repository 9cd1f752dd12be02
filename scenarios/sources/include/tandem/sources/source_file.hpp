// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/subsystem.hpp"
#include "tandem/text/document.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// A file that subsystems are made from. Files that it names are looked for beside it.
struct SourceFile {
  std::filesystem::path path;
  std::optional<std::string> text = {};     ///< in place of what the file holds, which then need not be there
  std::vector<std::string> overrides = {};  ///< "KEY=VALUE", of the command line

  text::Document document() const {
    auto all = text ? text::Document(path.string(), *text) : text::Document(path);
    all.set(overrides);
    return all;
  }
};

/// What make(file, parameters) makes with "key=value&key=value", or "": of a library. Throws Error for a
/// parameter that it does not take.
template <class Make>
std::unique_ptr<Subsystem> with_pairs(const SourceFile& file, const std::string& pairs, const Make& make) {
  const std::string owner = file.path.filename().string();
  Parameters parameters;
  if (!pairs.empty()) parameters.read(pairs, owner);
  auto subsystem = make(file, parameters);
  parameters.refuse_unused(owner);
  return subsystem;
}

}  // namespace tandem
