// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"
#include "words.hpp"

namespace tandem::fmi {
namespace {

/// Whether a value may not be what the port says it is: no double, or none that the type has.
bool needs_look(Type type) { return type != Type::float64; }

void check_read(const Variable& v, double value) {
  const Range range = range_of(v.type);
  if (is_real(v.type) || (value >= range.least && value <= range.most)) return;
  throw Error(ErrorCode::numerical,
              fmt::format("output '{}' is {}; allowed are whole numbers from {} to {}, which a double holds",
                          printable(v.name, 200), value, range.least, range.most));
}

/// As its type holds it.
double as_held(Instance& fmu, int variable, double value, double t) {
  const Variable& v = fmu.fmu().description.at(variable);
  const bool real = is_real(v.type);
  const double held = real ? value : std::round(value);
  const Range range = real ? range_of(v.type) : Range{v.min, v.max};
  if (!(held >= range.least && held <= range.most))
    throw Error(ErrorCode::numerical,
                fmt::format("input '{}' is {} at t = {} s; allowed are {}numbers from {} to {}",
                            printable(v.name, 200), value, t, real ? "" : "whole ", range.least, range.most));
  if (held != value && fmu.tells_first_of(variable))
    fmu.log().tell(fmt::format("input '{}' is {} at t = {} s, and is rounded to {}, as it is a whole number",
                               printable(v.name, 200), value, t, held));
  return held;
}

}  // namespace

Group::Group(const Description& description, const std::vector<Seat>& seats) {
  for (const Seat& seat : seats) {
    const Variable& v = description.at(seat.variable);
    auto part = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.type == v.type; });
    if (part == parts_.end()) part = parts_.insert(part, {v.type, {}, {}, {}});
    part->references.push_back(v.reference);
    part->seats.push_back(seat);
    part->values.resize(part->values.size() + static_cast<std::size_t>(seat.size));
  }
}

void Group::get(Instance& fmu, double* values) {
  for (Part& part : parts_) {
    fmu.get(part.type, part.references, part.values);
    auto from = part.values.cbegin();
    for (const Seat& seat : part.seats) {
      if (needs_look(part.type))
        std::for_each_n(from, seat.size,
                        [&](double v) { check_read(fmu.fmu().description.at(seat.variable), v); });
      std::copy_n(from, seat.size, values + seat.place);
      from += seat.size;
    }
  }
}

void Group::set(Instance& fmu, const double* values, double t) {
  for (Part& part : parts_) {
    auto to = part.values.begin();
    for (const Seat& seat : part.seats) {
      std::copy_n(values + seat.place, seat.size, to);
      if (needs_look(part.type))
        std::transform(to, to + seat.size, to, [&](double v) { return as_held(fmu, seat.variable, v, t); });
      to += seat.size;
    }
    fmu.set(part.type, part.references, part.values);
  }
}

}  // namespace tandem::fmi
