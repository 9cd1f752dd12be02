// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "declared.hpp"

#include "tandem/printable.hpp"

namespace tandem::wire {
namespace {

constexpr std::uint32_t longest_name = 4096;  // bytes
/// Bits of a declared parameter.
constexpr std::uint32_t is_word = 1, has_otherwise = 2;

DeclaredParameter read_parameter(Reader& in) {
  const auto bits = in.take<std::uint32_t>();
  if (bits > (is_word | has_otherwise))
    in.refuse("gives " + std::to_string(bits) + " for the kind of a parameter; allowed are 0 to 3");
  DeclaredParameter p;
  p.name = read_name(in);
  p.unit = read_name(in);
  p.otherwise = read_name(in);
  p.sentence = read_name(in);
  if (bits & is_word) p.unit.reset();
  if (!(bits & has_otherwise)) p.otherwise.reset();
  return p;
}

}  // namespace

std::string read_name(Reader& in) { return printable(in.take_text(longest_name), longest_name); }

void put_declared(Writer& frame, const DeclaredParameters& declared) {
  frame.put(static_cast<std::uint32_t>(declared.size()));
  for (const DeclaredParameter& p : declared) {
    frame.put((p.unit ? 0U : is_word) | (p.otherwise ? has_otherwise : 0U));
    frame.put_text(p.name);
    frame.put_text(p.unit.value_or(""));
    frame.put_text(p.otherwise.value_or(""));
    frame.put_text(p.sentence);
  }
}

DeclaredParameters read_declared(Reader& in) {
  const std::uint64_t count = in.take_count(20);
  if (count > most_parameters)
    in.refuse("declares " + std::to_string(count) + " parameters; allowed are up to " +
              std::to_string(most_parameters));
  DeclaredParameters declared;
  for (std::uint64_t i = 0; i < count; ++i) declared.push_back(read_parameter(in));
  check_declared(declared);
  return declared;
}

}  // namespace tandem::wire
