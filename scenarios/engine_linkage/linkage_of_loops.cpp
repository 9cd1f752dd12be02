// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The linkage of any number of loops as a shared library.
#include "engine_linkage/linkage.hpp"
#include "tandem/c_table.hpp"
#include "tandem/sources/source_file.hpp"

namespace {

std::unique_ptr<tandem::Subsystem> make(const std::string& pairs) {
  return tandem::with_pairs({"linkage_of_loops"}, pairs,
                            [](const tandem::SourceFile&, tandem::Parameters& parameters) {
                              return tandem::engine_linkage::make_linkage(parameters);
                            });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const tandem_subsystem_api* tandem_subsystem() {
  return tandem::c_table<make>();
}
