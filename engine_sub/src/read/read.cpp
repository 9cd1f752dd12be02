// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/read.hpp"

#include "read/reader.hpp"

namespace tandem::engine {

Description read_diagram(const std::filesystem::path& file, const ParameterValues& parameters) {
  DiagramFiles files;
  return files.read(file, parameters);
}

Description read_diagram(const std::string& name, const std::string& text,
                         const ParameterValues& parameters) {
  DiagramFiles files;
  const text::Document document(name, text);
  return DiagramReader({document, document.table(), ""}, parameters, files).read();
}

}  // namespace tandem::engine
