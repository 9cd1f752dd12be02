// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem {

/// Makes an instance of the subsystem that is checked; asked for several in each check.
using Opener = std::function<std::unique_ptr<Subsystem>()>;

struct CheckSettings {
  double t_start = 0.0;  ///< [s]
  /// Scalar inputs at the start, from which they move by about one unit of theirs in half a second; empty, or
  /// NaN for one: the start value of its port, or about 1.
  std::vector<double> inputs = {};
  std::vector<bool> constant = {};  ///< by scalar input, that it does not move; empty: all do
};

struct Finding {
  enum class Kind {
    wrong,     ///< the contract is broken
    left_out,  ///< the check asks for an ability that the subsystem says it has not
  };
  Kind kind;
  std::string check;     ///< one of check_names()
  std::string sentence;  ///< what was found, and what is allowed
};

/// The checks, each a sentence that holds for a subsystem.
std::vector<std::string> check_names();

/// Tries a subsystem as the contract (tandem/subsystem.hpp) says a coordinator may use it, some 100 own steps
/// long: ports, start, steps, early returns, landing, saved states, several instances. No finding of kind
/// `wrong`: nothing was found. What the subsystem throws is a finding, too. One that does not return from a
/// call is not noticed.
std::vector<Finding> check(const Opener& open, const CheckSettings& settings = {});

/// One of them. Throws Error for a name that is none of check_names().
std::vector<Finding> check(const std::string& name, const Opener& open, const CheckSettings& settings = {});

}  // namespace tandem
