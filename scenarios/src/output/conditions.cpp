// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/conditions.hpp"

#include <fstream>
#include <thread>

#include "commit.hpp"

namespace tandem::output {

std::string processor_model() {
  std::ifstream in("/proc/cpuinfo");  // Linux; elsewhere the file is absent and the model unknown
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string source_commit() { return TANDEM_COMMIT; }

nlohmann::ordered_json conditions(const Measured& measured) {
  return {{"processor", processor_model()},    {"cores", std::thread::hardware_concurrency()},
          {"commit", source_commit()},         {"version", TANDEM_VERSION},
          {"compiler", TANDEM_COMPILER},       {"reference", measured.reference},
          {"error_norm", measured.error_norm}, {"repetitions", measured.repetitions}};
}

nlohmann::ordered_json conditions(int repetitions) {
  auto all = conditions(Measured{"exact motion", "(FR/N) rms(x1 - x1_exact) / rms(x1_exact)", ""});
  all["repetitions"] = repetitions;
  return all;
}

}  // namespace tandem::output
