// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/read.hpp"

#include "read/reader.hpp"

namespace tandem::engine {

Description read_diagram(const std::filesystem::path& file, const ParameterValues& parameters,
                         const FileBounds& bounds) {
  return read_diagram(text::Document(file), parameters, bounds);
}

Description read_diagram(const text::Document& document, const ParameterValues& parameters,
                         const FileBounds& bounds) {
  return DiagramFiles(bounds.folder).read(document, {parameters, bounds.parameters});
}

Description read_diagram(const std::string& name, const std::string& text, const ParameterValues& parameters,
                         const FileBounds& bounds) {
  return read_diagram(text::Document(name, text), parameters, bounds);
}

}  // namespace tandem::engine
