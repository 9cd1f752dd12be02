// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tandem/error.hpp"

namespace tandem::mbs {

/// A setting of a formulation or integrator, and whose it is, for the sentence that refuses it.
struct Setting {
  const char *owner, *name;
  double value;

  [[noreturn]] void refuse(const char* allowed) const {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: {} is {}; allowed is {}", owner, name, value, allowed));
  }
  void at_least(double least, const char* allowed) const {
    if (!(value >= least) || !std::isfinite(value)) refuse(allowed);
  }
  void positive() const {
    if (!(value > 0.0) || !std::isfinite(value)) refuse("a number above 0");
  }
  void count() const { at_least(1.0, "1 or more"); }
};

inline void check_beta(const char* owner, double beta) {
  const Setting setting{owner, "beta", beta};
  if (!(beta >= 0.0833 && beta <= 0.25)) setting.refuse("1/12 to 1/4 (from 0.0833 on)");
}

}  // namespace tandem::mbs
