// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/conditions.hpp"

#include <thread>

#include "tandem/output/provenance.hpp"

namespace tandem::output {

nlohmann::ordered_json conditions(const Measured& measured) {
  return {{"processor", processor_model()},
          {"cores", std::thread::hardware_concurrency()},
          {"commit", source_commit()},
          {"version", version()},
          {"compiler", compiler()},
          {"reference", measured.reference},
          {"error_norm", measured.error_norm},
          {"repetitions", measured.repetitions}};
}

}  // namespace tandem::output
