// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <variant>

#include "cli/say.hpp"
#include "tandem/declared_parameters.hpp"

namespace tandem::cli {

/// "parameter NAME = VALUE UNIT: SENTENCE", or that it is needed.
inline void print_parameter(const DeclaredParameter& p) {
  const std::string sentence = p.sentence.empty() ? "" : ": " + p.sentence;
  if (!p.otherwise)
    say("  parameter {}{}, needed{}\n", p.name, p.unit ? " [" + *p.unit + "]" : ", a word", sentence);
  else if (p.unit)
    say("  parameter {} = {}{}{}\n", p.name, *p.otherwise, p.unit->empty() ? "" : " " + *p.unit, sentence);
  else
    say("  parameter {} = '{}'{}\n", p.name, *p.otherwise, sentence);
}

/// Of a diagram or a mechanism.
template <class Parameter>
void print_parameter(const Parameter& p) {
  if (const auto* number = std::get_if<double>(&p.value))
    print_parameter(DeclaredParameter{p.name, p.unit, fmt::format("{}", *number), ""});
  else
    print_parameter(DeclaredParameter{p.name, {}, std::get<std::string>(p.value), ""});
}

}  // namespace tandem::cli
