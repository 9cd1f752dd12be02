// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "tandem/subsystem_info.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::exported {

/// A variable of an exported FMU. Its value reference, in both versions, is its place among variables().
struct Variable {
  enum class Kind {
    time,
    input,
    output,
    derivative,  ///< of an output
    state,       ///< of Model Exchange, if no output shows it
    rate,        ///< of a state
    indicator,   ///< of events
    number,      ///< a parameter of the source's file
    word,        ///< likewise
    extrapolate  ///< whether an input without derivatives goes on along its last two values
  };
  std::string name;
  Kind kind;
  std::string unit = {};  ///< "": not said
  int index = 0;          ///< of its scalar among inputs or outputs, of a state; of a parameter in the file
  int order = 0;          ///< of a derivative, or how many derivatives of an output there are
  bool held = false;      ///< of an output
  bool reset = false;     ///< of a state, also of an output that stands for one: events may put it
  double start = 0.0;     ///< of an input and a number
  std::string word = {};  ///< likewise, of a word
  std::string parameter = {};  ///< of a number or a word: its name in the file
};

/// What a source has in Model Exchange.
struct ExchangedStates {
  std::vector<std::string> names;
  std::vector<char> reset;      ///< by state: events may put it
  std::vector<int> of_outputs;  ///< by scalar output: the state that it stands for; -1: none
  int indicators = 0;

  /// Whether an FMU of this description can be these: with the same states, and no more events.
  bool covers(const ExchangedStates& other) const;
};

/// Time, the scalars of the ports with the derivatives that outputs give, the parameters. Where an output or
/// a parameter has the name of one before it, its own is "output.NAME" or "parameter.NAME". A derivative
/// stands behind its output. Of Model Exchange outputs have no derivatives but as states.
/// - start: of each scalar input.
/// - exchange: null for Co-Simulation.
/// Throws Error(invalid_argument) for names that are not distinct even so.
std::vector<Variable> variables(const SubsystemInfo& info, const std::vector<double>& start,
                                const std::vector<text::FileParameter>& parameters,
                                const ExchangedStates* exchange = nullptr);

}  // namespace tandem::exported
