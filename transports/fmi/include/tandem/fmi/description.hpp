// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tandem::fmi {

// What an FMU says of itself (modelDescription.xml), by the words of the standard: Functional Mock-up
// Interface for Model Exchange and Co-Simulation, version 2.0 (fmi-standard.org).

enum class Type { real, integer, boolean, enumeration, string };
enum class Causality { parameter, calculated_parameter, input, output, local, independent };
enum class Variability { constant, fixed, tunable, discrete, continuous };

struct Variable {
  std::string name, description;
  std::uint32_t reference = 0;  ///< several variables of one type may have the same: they are one number
  Type type = Type::real;
  Causality causality = Causality::local;
  Variability variability = Variability::discrete;
  std::string unit;  ///< as tandem writes it: "N m", "m/s^2"; empty: not said
  std::optional<std::string> start;
  double start_value = std::numeric_limits<double>::quiet_NaN();  ///< of any type but string; booleans: 0, 1
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  double nominal = 1.0;
  int derivative_of = -1;  ///< the variable whose time derivative it is
};

/// Of which variables an unknown follows at once.
struct Unknown {
  int variable;
  bool of_all = false;  ///< nothing is said: of every input
  std::vector<int> of = {};
};

/// One of the two ways in which an FMU may be run.
struct Offer {
  std::string model;  ///< modelIdentifier: its library's name
  bool needs_tool = false;
  bool once_per_process = false;
  bool keeps_state = false, serializes_state = false;
  bool interpolates_inputs = false;       ///< Co-Simulation: takes derivatives of inputs
  bool needs_no_completed_steps = false;  ///< Model Exchange
};

struct Experiment {
  std::optional<double> step, tolerance;
};

struct Description {
  std::string name, guid, tool, text;
  std::optional<Offer> co_simulation, model_exchange;
  int event_indicators = 0;
  Experiment experiment;
  std::vector<Variable> variables;
  /// Of the model's structure; derivatives: of its states, in order.
  std::vector<Unknown> outputs, derivatives;
};

/// Reads the text of a modelDescription.xml. Nothing that it names is looked for. `file`: how errors call it.
/// Throws Error(invalid_argument) with file, line, the value found and what is allowed.
Description read_description(const std::string& text, const std::string& file);

/// A unit of FMI as tandem writes it.
std::string unit_of_fmi(const std::string& unit);

}  // namespace tandem::fmi
