// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/fmi/archive.hpp"

namespace tandem::fmi {

// What an FMU says of itself (modelDescription.xml), by the words of the standard: Functional Mock-up
// Interface, versions 2.0 and 3.0 (fmi-standard.org).

enum class Version { two, three };
/// Real and Integer of 2.0 are float64 and int32. From text on they are no numbers.
enum class Type {
  float64,
  float32,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  boolean,
  enumeration,
  text,
  binary,
  clock
};
inline bool is_real(Type t) { return t <= Type::float32; }
inline bool is_number(Type t) { return t < Type::text; }

enum class Causality {
  parameter,
  calculated_parameter,
  structural_parameter,
  input,
  output,
  local,
  independent
};
enum class Variability { constant, fixed, tunable, discrete, continuous };

/// One dimension of an array: a number, or that of a structural parameter.
struct Dimension {
  std::uint64_t size;
  int variable = -1;
};

struct Variable {
  std::string name, description;
  std::uint32_t reference = 0;  ///< several variables of one type may have the same: they are one number
  Type type = Type::float64;
  Causality causality = Causality::local;
  Variability variability = Variability::discrete;
  std::vector<Dimension> dimensions = {};  ///< of an array
  int size = 1;                            ///< number of scalars
  std::string unit = {};                   ///< as tandem writes it: "N m", "m/s^2"; empty: not said
  std::optional<std::string> start = {};
  std::vector<double> start_values = {};  ///< of a number, by scalar; booleans: 0, 1
  std::shared_ptr<const std::map<std::string, double>> items = {};  ///< of an enumeration, by name
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  double nominal = 1.0;
  int derivative_of = -1;     ///< the variable whose time derivative it is
  bool intermediate = false;  ///< an input of Co-Simulation that may be set within a step
  bool clocked = false;       ///< has a value where a clock of the FMU ticks
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
  bool interpolates_inputs = false;       ///< Co-Simulation of 2.0: takes derivatives of inputs
  bool needs_no_completed_steps = false;  ///< Model Exchange
  bool gives_derivatives = false;         ///< directional ones
  bool derives_outputs = false;  ///< Co-Simulation: gives time derivatives of outputs, of some of them
  /// Co-Simulation of 3.0.
  bool varies_steps = false, returns_early = false, has_events = false, asks_for_inputs = false;
  std::optional<double> fixed_step = {};  ///< [s], of its own
};

struct Experiment {
  std::optional<double> step, tolerance;
};

struct Description {
  Version version = Version::two;
  std::string name, guid, tool, text;  ///< guid: in 3.0 its instantiationToken
  std::optional<Offer> co_simulation, model_exchange;
  int event_indicators = 0;
  Experiment experiment;
  std::vector<Variable> variables;
  /// Of the model's structure; derivatives: of its states, in order.
  std::vector<Unknown> outputs, derivatives;
  std::vector<int> indicators;  ///< of 3.0: variables

  const Variable& at(int variable) const { return variables[static_cast<std::size_t>(variable)]; }
  int state_size() const;
};

/// Sizes of arrays from the start values of structural parameters, and with them how many event indicators
/// there are. Throws Error for an array of more than 2^20 scalars, for 2^26 in all, and for a derivative of
/// another size than its state.
void set_sizes(Description& description);

/// Reads the text of a modelDescription.xml. Nothing that it names is looked for. `file`: how errors call it.
/// Throws Error(invalid_argument) with file, line, the value found and what is allowed.
Description read_description(const std::string& text, const std::string& file);
/// That of an FMU.
Description description_of(const Archive& archive, const std::filesystem::path& file);

/// A variable's name as that of a port, which has no [ ] , " and blanks: "a[1,2]" is "a(1;2)".
std::string port_name(const std::string& variable);

}  // namespace tandem::fmi
