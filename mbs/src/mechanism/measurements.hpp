// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "element_set.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// The quantities of elements that outputs name. An element is measured once where a state stands, however
/// many outputs it has. Nothing here allocates after construction.
class Measurements {
 public:
  /// `mechanism` must outlive it.
  Measurements(const Mechanism& mechanism, const std::vector<Output>& outputs);

  /// Of an output of the kind `quantity`, by its number.
  const std::string& unit(int output) const { return one(output).unit; }
  bool follows_inputs(int output) const { return one(output).follows_inputs; }

  /// Measures all elements; then the values at that state.
  void measure(const State& s);
  double value(int output) const { return values_[one(output).place]; }
  /// Measures the elements with quantities that don't follow inputs again; then the rates of these, by
  /// central differences along the motion, in which inputs stay as they are.
  void measure_rates(const State& s);
  double rate(int output) const { return rates_[one(output).place]; }

 private:
  struct Measured {
    GatheredElement element;
    std::size_t first, last;  ///< of its values
    bool has_rates;           ///< an output names a quantity that does not follow inputs
  };
  struct One {
    std::size_t place = 0;  ///< among all values
    std::string unit = {};
    bool follows_inputs = false;
  };
  const One& one(int output) const { return ones_[static_cast<std::size_t>(output)]; }
  void add(const Output& output, One& to);
  std::size_t place_of(int element);
  void measure(Measured& of, const ElementState& at, std::vector<double>& to);
  void add_difference(Measured& m, const State& s, double by, double along_q, double along_v);

  const Mechanism& mechanism_;
  std::vector<int> elements_;  ///< by entry of measured_, the description's
  std::vector<Measured> measured_;
  std::vector<One> ones_;  ///< by output; of those of the kind
  std::vector<double> values_, rates_, before_, after_;
};

}  // namespace tandem::mbs
