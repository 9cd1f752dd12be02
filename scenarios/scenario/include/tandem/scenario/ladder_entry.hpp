// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tandem/scenario/comparison.hpp"
#include "tandem/text/place.hpp"

namespace tandem::scenario {

/// By what the rungs of a ladder are judged: an output's difference over time.
struct LadderQuantity {
  std::string quantity;
  double tolerance;  ///< in `unit`, or as a fraction of the largest magnitude, or of the rms, in the richest
  std::string unit;  ///< empty: a fraction
  text::Place place;
  Measure measure = {};
};

/// One model of the scene: a scenario file with overrides, or results of one.
struct LadderRung {
  std::string name;
  std::filesystem::path file;                  ///< of results: CSV, .npy or their folder
  std::vector<std::string> overrides;          ///< "KEY=VALUE"
  std::map<std::string, std::string> outputs;  ///< of judged quantities that have another name here
  std::map<std::string, double> constants;     ///< judged quantities that are this number here, in their unit
  text::Place place;
};

/// A scene's models from simple to rich.
struct LadderEntry {
  std::vector<LadderQuantity> quantities;
  std::vector<LadderRung> rungs;
};

}  // namespace tandem::scenario
