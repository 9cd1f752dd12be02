// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tandem/declared_parameters.hpp"
#include "tandem/samples.hpp"

namespace tandem {

/// An input or output. An array port has size > 1; its scalars follow one another in the flattened numbering.
struct Port {
  std::string name;
  std::string unit;     ///< "1" for none; SI unless it says otherwise ("rpm"); "": not said, fits all
  int size = 1;         ///< number of scalars
  int derivatives = 0;  ///< of an output: time derivatives given with each sample, 0 to 3
  /// Of an input: its value when nothing else is known.
  double start = std::numeric_limits<double>::quiet_NaN();
  bool held = false;  ///< of an output: constant from each of its samples, that instant included, to the next
  double nominal = 1.0;  ///< of an output: its usual magnitude, in its unit; above 0
  /// Of an array input whose scalars start differently: each one's, in place of start. It does not go over a
  /// wire or the C table, where start alone is known.
  std::vector<double> starts = {};

  double start_of(int element) const {
    return starts.empty() ? start : starts[static_cast<std::size_t>(element)];
  }
};

/// Which port a scalar of the flattened numbering belongs to.
struct Scalar {
  const Port* port;
  int element;
  std::string name() const;  ///< "x" or, of an array port, "x[2]"
};
/// Precondition: 0 <= index < the number of scalars.
Scalar scalar_at(const std::vector<Port>& ports, int index);

/// The scalar output at time t depends on that scalar input at the same t (flattened indices).
struct Feedthrough {
  int output, input;
};

/// What a subsystem can do beyond the least.
struct Abilities {
  bool chooses_step = false;  ///< Own steps vary.
  bool lands = false;         ///< Can cut a step so that it ends at t_limit.
  bool saves_state = false;
  bool restarts = false;  ///< May be initialized again after an advance.
  bool reactive_inputs = false;
  bool serializes_state = false;  ///< Gives saved states as bytes, and takes them.
  bool sampled = false;           ///< Acts at instants of its own only, and all its outputs are held.
  /// Returns where its outputs jump (Stop::event), with two rows there, the second marked; needs room for
  /// two.
  bool events = false;
};
/// From bits of subsystem_info.h (TANDEM_LANDS, ...); bits that are not known are left out.
Abilities abilities_from(std::uint32_t bits);

/// A continuous or discrete state of a model, as a number.
struct StateName {
  std::string name, unit;  ///< as of a Port
};

/// Of a sampled subsystem.
struct Sampling {
  double period = 0.0;   ///< [s]: the least time between two instants; above 0
  double latency = 0.0;  ///< [s]: its outputs change this long after each instant
};

struct SubsystemInfo {
  std::string name;
  std::vector<Port> inputs, outputs;
  std::vector<Feedthrough> feedthrough;
  Abilities abilities;
  Sampling sampling = {};
  DeclaredParameters parameters = {};  ///< of its kind; none: it takes any, and refuses what it does not know

  int input_size() const { return scalars(inputs); }    ///< number of scalar inputs
  int output_size() const { return scalars(outputs); }  ///< number of scalar outputs
  int derivatives() const {                             ///< blocks of derivatives in a sample row
    int most = 0;
    for (const Port& port : outputs) most = port.derivatives > most ? port.derivatives : most;
    return most;
  }
  /// Whether some outputs are held.
  bool holds() const {
    for (const Port& port : outputs)
      if (port.held) return true;
    return false;
  }
  /// Doubles in a sample row.
  std::int64_t row_size() const {
    return Samples::header + std::int64_t{output_size()} * (1 + derivatives());
  }

 private:
  static int scalars(const std::vector<Port>& ports) {
    int sum = 0;
    for (const Port& port : ports) sum += port.size;
    return sum;
  }
};
/// Its abilities as bits of subsystem_info.h, with TANDEM_HOLDS where it holds.
std::uint32_t to_bits(const SubsystemInfo& info);

}  // namespace tandem
