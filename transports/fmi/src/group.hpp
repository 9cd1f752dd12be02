// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "instance.hpp"

namespace tandem::fmi {

/// Variables whose values are read, or set, together: one call for each type among them.
class Group {
 public:
  Group(const Description& description, const std::vector<Seat>& seats);
  bool empty() const { return reals_.empty() && wholes_.empty() && flags_.empty(); }

  /// values[place] of each becomes its value.
  void get(Instance& fmu, double* values);
  /// The other way round. A value that is no whole number where one is needed is rounded, which is told
  /// once for each variable; one out of the variable's range is Error(numerical) with the time t [s].
  void set(Instance& fmu, const double* values, double t);

 private:
  /// Of one type.
  struct Part {
    std::vector<fmi2ValueReference> references;
    std::vector<Seat> seats;
    bool empty() const { return references.empty(); }
    std::size_t size() const { return references.size(); }
  };
  void add(Part& part, const Variable& v, Seat seat);
  void to_wholes(Instance& fmu, Part& part, const double* values, double t);
  void from_wholes(const Part& part, double* values) const;

  Part reals_, wholes_, flags_;
  std::vector<double> real_values_;
  std::vector<int> whole_values_;
};

}  // namespace tandem::fmi
