// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "functions.hpp"
#include "tandem/fmi/description.hpp"

namespace tandem::fmi {

/// Takes what an FMU tells, and what is told of it.
using Tell = std::function<void(const std::string&)>;

/// What an FMU writes into its log.
class Log {
 public:
  /// all: every message is told, else none. `description` outlives it.
  Log(std::string name, const Description& description, bool all, Tell tell);
  void tell(const std::string& sentence) const;
  /// The newest message of a call that went wrong, once; empty if there is none.
  std::string take_last();

  /// What the FMU says with a status. Nothing is thrown through the FMU: what fails is not told.
  void add(Status status, const char* message) noexcept;

 private:
  std::string with_names(const std::string& message) const;

  std::string name_;
  const Description& description_;
  bool all_;
  Tell tell_;
  std::string last_;
};

}  // namespace tandem::fmi
