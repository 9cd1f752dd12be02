// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "functions.hpp"
#include "kinds.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;

/// offset + gain input.
void gain(Lowering& to, Arguments& a) {
  to.define("", to.linear(a.number("offset", 0.0), a.number("gain"), a.wire("input")));
}

/// The inputs times their factors, by default 1.
void sum(Lowering& to, Arguments& a) {
  const auto inputs = a.wires("inputs");
  auto factors = a.has("gains") ? a.numbers("gains") : std::vector<double>(inputs.size(), 1.0);
  if (factors.size() != inputs.size())
    a.refuse("gains", fmt::format("an array of {}", factors.size()), fmt::format("one of {}", inputs.size()));
  to.define("", to.sum(inputs, factors));
}

void product(Lowering& to, Arguments& a) {
  const auto inputs = a.wires("inputs");
  int result = inputs[0];
  for (std::size_t k = 1; k < inputs.size(); ++k) result = to.operation(Code::product, result, inputs[k]);
  to.define("", inputs.size() == 1 ? to.linear(0.0, 1.0, result) : result);
}

void quotient(Lowering& to, Arguments& a) {
  const int numerator = a.wire("numerator"), denominator = a.wire("denominator");
  to.define("", to.operation(Code::quotient, numerator, denominator));
}

/// coefficients[0] + coefficients[1] input + ..
void polynomial(Lowering& to, Arguments& a) {
  const auto c = a.numbers("coefficients");
  to.define("", to.operation(Code::polynomial, a.wire("input"), static_cast<int>(c.size()) - 1, c));
}

template <class List>
std::vector<std::string> names(const List& list) {
  std::vector<std::string> all;
  for (const auto& entry : list) all.push_back(entry.name);
  return all;
}

/// A function of one input, or of two.
void function(Lowering& to, Arguments& a) {
  a.required_text("function", listed(a.has("inputs") ? names(functions2) : names(functions)));
  if (a.has("inputs")) {
    const auto inputs = a.wires("inputs");
    if (inputs.size() != 2) a.refuse("inputs", fmt::format("an array of {}", inputs.size()), "one of 2");
    const auto number = static_cast<int>(a.word("function", names(functions2)));
    to.define("", to.operation(Code::function2, inputs[0], inputs[1], {}, number));
    return;
  }
  const auto number = static_cast<int>(a.word("function", names(functions)));
  to.define("", to.operation(Code::function, a.wire("input"), number));
}

}  // namespace

const std::vector<BlockKind> algebraic_blocks = {{"gain", gain},
                                                 {"sum", sum},
                                                 {"product", product},
                                                 {"quotient", quotient},
                                                 {"polynomial", polynomial},
                                                 {"function", function}};

}  // namespace tandem::engine
