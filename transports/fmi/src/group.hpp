// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "instance.hpp"

namespace tandem::fmi {

/// Variables whose values are read, or set, together: one call for each type among them.
class Group {
 public:
  Group(const Description& description, const std::vector<Seat>& seats);
  bool empty() const { return parts_.empty(); }

  /// values[place] of each becomes its value. Error(numerical) for a whole number that is no double.
  void get(Instance& fmu, double* values);
  /// The other way round. A value that is no whole number where one is needed is rounded, which is told
  /// once for each variable; one out of the variable's range is Error(numerical) with the time t [s].
  void set(Instance& fmu, const double* values, double t);

 private:
  /// Of one type.
  struct Part {
    Type type;
    std::vector<std::uint32_t> references;
    std::vector<Seat> seats;
    std::vector<double> values;  ///< of all, one variable after the other
  };
  std::vector<Part> parts_;
};

}  // namespace tandem::fmi
