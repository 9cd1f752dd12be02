// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem {

/// What a library of three functions does not say of itself. They are, in C:
/// - `void initiate(void)`: puts its state at the start.
/// - `void step(const double* inputs, double* outputs)`: one step: takes the inputs of its beginning, gives
///   the outputs of its end.
/// - `void clean_up(void)`: before it is initiated again or leaves.
struct ThreeFunctions {
  std::string initiate = "initiate", step = "step", clean_up = "clean_up";  ///< their names
  double own_step = 0.0;                                                    ///< [s], as it is built in
  std::vector<Port> inputs, outputs;
  std::vector<double> start;  ///< outputs before the first step
};

/// Ports of a text "name:unit,name:unit"; with values, "name:unit=value", where a list to take them is given.
/// Throws Error that begins with `what` for another text.
std::vector<Port> ports_of_text(const std::string& what, const std::string& text,
                                std::vector<double>* values = nullptr);

/// An instance of such a library, which has one state: each instance loads a copy of the file. Its inputs are
/// held over a step. It has no ability but to restart. Throws Error that names the file.
std::unique_ptr<Subsystem> load_three_functions(const std::filesystem::path& file, ThreeFunctions functions);

}  // namespace tandem
