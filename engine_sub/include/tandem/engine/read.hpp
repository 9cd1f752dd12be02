// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "tandem/engine/description.hpp"
#include "tandem/text/document.hpp"

namespace tandem::engine {

/// Values of a diagram's parameters by name, in place of those in its file.
using ParameterValues = std::map<std::string, ParameterValue>;

/// Parameters whose given value, where it names a file, must name one below a folder after links are
/// resolved. The value that stands in the diagram, and values that it allows by a list, may name any file.
struct FileBounds {
  std::filesystem::path folder = {};
  std::set<std::string> parameters = {};
};

/// A diagram from its TOML file (docs/diagrams.md has the form). Throws Error that names file, line, the
/// value found and the values allowed.
Description read_diagram(const std::filesystem::path& file, const ParameterValues& parameters = {},
                         const FileBounds& bounds = {});

/// The same of a file that has been opened.
Description read_diagram(const text::Document& document, const ParameterValues& parameters = {},
                         const FileBounds& bounds = {});

/// The same from a text; `name` is what errors call it, and files that it names are looked for in the folder
/// of that name.
Description read_diagram(const std::string& name, const std::string& text,
                         const ParameterValues& parameters = {}, const FileBounds& bounds = {});

}  // namespace tandem::engine
