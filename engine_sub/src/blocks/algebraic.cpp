// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kinds.hpp"
#include "math_functions.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

using Code = Operation::Code;

/// offset + gain input.
void gain(Lowering& to, Arguments& a) {
  to.define("", to.linear(a.number("offset"), a.number("gain"), a.wire("input")));
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
  const auto number = static_cast<int>(a.word("function")), ones = static_cast<int>(functions.size());
  const bool of_two = a.has("inputs");
  if (of_two != (number >= ones))
    a.refuse("function", "'" + a.text("function") + "'",
             listed(of_two ? names(functions2) : names(functions)) + " of " +
                 (of_two ? "two inputs" : "one input"));
  if (!of_two) return to.define("", to.operation(Code::function, a.wire("input"), number));
  const auto inputs = a.wires("inputs");
  if (inputs.size() != 2) a.refuse("inputs", fmt::format("an array of {}", inputs.size()), "one of 2");
  to.define("", to.operation(Code::function2, inputs[0], inputs[1], {}, number - ones));
}

void keys_of_function(text::KeyList& to) {
  auto words = names(functions);
  for (const std::string& name : names(functions2)) words.push_back(name);
  to.need("function", Type::word, "The function; the last six of two inputs.", {.words = words})
      .may("input", Type::signal, "Of a function of one.")
      .may("inputs", Type::signals, "Of a function of two.", {.allowed = "two"});
}

}  // namespace

const std::vector<BlockKind> algebraic_blocks = {
    {"gain", gain, "offset + gain input.",
     [](text::KeyList& to) {
       to.need("input", Type::signal, "The signal.")
           .need("gain", Type::number, "The factor.")
           .may("offset", Type::number, "What is added.", {.otherwise = "0.0"});
     }},
    {"sum", sum, "The sum of signals, each times its gain.",
     [](text::KeyList& to) {
       to.need("inputs", Type::signals, "The signals.")
           .may("gains", Type::numbers, "One for each; without them all 1.");
     }},
    {"product", product, "The product of signals.",
     [](text::KeyList& to) { to.need("inputs", Type::signals, "The signals."); }},
    {"quotient", quotient, "numerator / denominator.",
     [](text::KeyList& to) {
       to.need("numerator", Type::signal, "A signal.").need("denominator", Type::signal, "A signal.");
     }},
    {"polynomial", polynomial, "A polynomial of a signal.",
     [](text::KeyList& to) {
       to.need("input", Type::signal, "The signal.")
           .need("coefficients", Type::numbers, "From the constant upwards.");
     }},
    {"function", function,
     "A function of one signal, or of two. It has no events: `abs` and `sign` bend within a step.",
     keys_of_function}};

}  // namespace tandem::engine
