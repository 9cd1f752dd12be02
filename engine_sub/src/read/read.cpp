// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/read.hpp"

#include "read/reader.hpp"

namespace tandem::engine {

Description read_diagram(const std::filesystem::path& file, const ParameterValues& parameters,
                         const FileBounds& bounds) {
  DiagramFiles files(bounds.folder);
  return files.read(file, {parameters, bounds.parameters});
}

Description read_diagram(const std::string& name, const std::string& text, const ParameterValues& parameters,
                         const FileBounds& bounds) {
  DiagramFiles files(bounds.folder);
  const text::Document document(name, text);
  return DiagramReader({document, language_of_diagrams()}, {parameters, bounds.parameters}, files).read();
}

}  // namespace tandem::engine
