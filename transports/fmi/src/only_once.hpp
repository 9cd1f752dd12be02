// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "fmu.hpp"

namespace tandem::fmi {

/// That an FMU is there which may be there once in a process. Throws Error(not_supported) if it is already.
class OnlyOnce {
 public:
  explicit OnlyOnce(const Fmu& fmu);
  ~OnlyOnce();
  OnlyOnce(const OnlyOnce&) = delete;
  OnlyOnce& operator=(const OnlyOnce&) = delete;

 private:
  std::string token_;  ///< empty: it may be there more often
};

}  // namespace tandem::fmi
