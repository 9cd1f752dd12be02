// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/provenance.hpp"

#include <fstream>

#include "commit.hpp"

namespace tandem::output {

std::string version() { return TANDEM_VERSION; }

std::string compiler() { return TANDEM_COMPILER; }

std::string source_commit() { return TANDEM_COMMIT; }

std::string processor_model() {
  std::ifstream in("/proc/cpuinfo");  // Linux; elsewhere the file is absent and the model unknown
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace tandem::output
