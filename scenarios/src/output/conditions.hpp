// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace tandem::output {

/// What a chart says of its figures, besides where they were taken.
struct Measured {
  std::string reference, error_norm, repetitions;
};

/// Under which conditions figures were taken: processor, cores, commit, version, compiler, reference, error
/// norm, repetitions.
nlohmann::ordered_json conditions(const Measured& measured);

}  // namespace tandem::output
