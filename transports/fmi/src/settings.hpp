// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/fmi/description.hpp"
#include "tandem/fmi/fmi.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem::fmi {

enum class Kind { co_simulation, model_exchange };

/// What an input of Co-Simulation is over a step.
enum class Held { mean, left, right, middle, derivatives, intermediate };

/// A value for a variable before the start.
struct Setting {
  int variable;
  std::vector<double> numbers;  ///< by scalar, of any type but text
  std::string text;
};

struct Settings {
  Kind kind = Kind::co_simulation;
  double step = 0.0;  ///< [s]
  Held held = Held::mean;
  int order = 1;                 ///< of derivatives
  bool derives_outputs = false;  ///< the FMU gives their time derivatives where no variable does
  bool lands = false, trusts_state = false, logs = false;
  std::optional<double> tolerance;
  std::vector<Setting> values;
  std::map<std::string, std::string> units;  ///< of ports, in place of what the description says
  std::vector<std::string> outputs;          ///< variables that are outputs beside those that are said to be
  /// Of Model Exchange; null: the classical Runge-Kutta method.
  std::shared_ptr<AdaptiveIntegrator> integrator = {};

  /// Look::input_order.
  int input_order() const {
    if (kind == Kind::model_exchange || held == Held::intermediate) return 0;
    return held == Held::left || held == Held::right ? 1 : std::max(order, 1) + 1;
  }
};

/// Words of "fmu:".
Words fmu_words();

/// What the parameters and the description say; arrays of the description have the sizes that they give.
/// Throws Error(invalid_argument) for what the FMU has not.
Settings take_settings(Description& description, Parameters& parameters, const FmuIntegrators& integrators);

inline const Offer& offer_of(const Description& d, Kind kind) {
  return kind == Kind::co_simulation ? *d.co_simulation : *d.model_exchange;
}
std::string name_of(Kind kind);

}  // namespace tandem::fmi
