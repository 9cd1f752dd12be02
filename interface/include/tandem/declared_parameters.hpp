// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tandem/error.hpp"
#include "tandem/subsystem_info.h"

namespace tandem {

/// A parameter that a kind of subsystem takes: tandem_parameter.
struct DeclaredParameter {
  std::string name;
  std::optional<std::string> unit;       ///< of a number, "1" for none; a word has none
  std::optional<std::string> otherwise;  ///< what stands where none is given; absent: one has to be
  std::string sentence;                  ///< what it is
};
using DeclaredParameters = std::vector<DeclaredParameter>;

/// The most that a kind may declare, and bytes of each text.
constexpr std::size_t most_parameters = 4096, longest_parameter_text = 4096;

/// From C. Throws Error(invalid_argument) for an entry without name or sentence, and as check_declared()
/// does.
DeclaredParameters declared_from(std::span<const tandem_parameter> parameters);
/// Throws Error(invalid_argument) for too many, texts too long, a name that is none or is there twice, and an
/// `otherwise` that is no number where it has to be one.
void check_declared(const DeclaredParameters& declared);

/// Throws Error(invalid_argument) for what "key=value&key=value" gives that is not declared, with the nearest
/// that is, is there twice, or is no number where it has to be one. None declared: any are allowed.
void check_given(const DeclaredParameters& declared, const std::string& pairs);

/// Values of declared parameters: given, or what stands otherwise.
class ParameterValues {
 public:
  /// Throws as check_given() does, and for one that has to be given and is not.
  ParameterValues(const DeclaredParameters& declared, const std::string& pairs);

  /// Throw Error(internal) for a name that is not declared, and number() for a text that is none.
  double number(std::string_view name) const;
  const std::string& word(std::string_view name) const;

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

/// No subsystem was made: why, and the parameters that its kind declares.
class NotMade : public Error {
 public:
  NotMade(const Error& why, DeclaredParameters declared)
      : Error(why.code(), why.what()), parameters_(std::move(declared)) {}
  const DeclaredParameters& parameters() const { return parameters_; }

 private:
  DeclaredParameters parameters_;
};

/// Throws the same error with a text before its sentence.
[[noreturn]] void throw_behind(const std::string& text, const Error& error);

}  // namespace tandem
