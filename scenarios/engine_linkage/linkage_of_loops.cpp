// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The linkage as a shared library: `loops`, and the parameters of a mechanism.
#include <cmath>

#include "engine_linkage/linkage.hpp"
#include "tandem/c_table.hpp"
#include "tandem/error.hpp"
#include "tandem/sources/mechanism.hpp"

namespace {

int loops_of(tandem::Parameters& parameters) {
  const double loops = parameters.number("loops", 1.0);
  if (!(loops >= 1.0 && loops <= 1e6 && loops == std::floor(loops)))
    throw tandem::Error(tandem::ErrorCode::invalid_argument,
                        "parameter 'loops' is " + std::to_string(loops) + "; allowed are 1, 2, ... 1000000");
  return static_cast<int>(loops);
}

std::unique_ptr<tandem::Subsystem> make(const std::string& pairs) {
  return tandem::with_pairs({"linkage_of_loops"}, pairs,
                            [](const tandem::SourceFile& file, tandem::Parameters& parameters) {
                              const auto text = tandem::engine_linkage::linkage_text(loops_of(parameters));
                              return tandem::make_mechanism({file.path, text}, parameters);
                            });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const tandem_subsystem_api* tandem_subsystem() {
  return tandem::c_table<make>();
}
