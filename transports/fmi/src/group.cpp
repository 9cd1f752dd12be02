// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {

Group::Group(const Description& description, const std::vector<Seat>& seats) {
  for (const Seat& seat : seats) {
    const Variable& v = description.variables[static_cast<std::size_t>(seat.variable)];
    add(v.type == Type::real ? reals_ : v.type == Type::boolean ? flags_ : wholes_, v, seat);
  }
  real_values_.resize(reals_.size());
  whole_values_.resize(std::max(wholes_.size(), flags_.size()));
}

void Group::add(Part& part, const Variable& v, Seat seat) {
  part.references.push_back(v.reference);
  part.seats.push_back(seat);
}

void Group::get(Instance& fmu, double* values) {
  if (!reals_.empty()) {
    fmu.call(&Functions::GetReal, "fmi2GetReal", reals_.references.data(), reals_.size(),
             real_values_.data());
    for (std::size_t k = 0; k < reals_.size(); ++k) values[reals_.seats[k].place] = real_values_[k];
  }
  if (!wholes_.empty()) {
    fmu.call(&Functions::GetInteger, "fmi2GetInteger", wholes_.references.data(), wholes_.size(),
             whole_values_.data());
    from_wholes(wholes_, values);
  }
  if (!flags_.empty()) {
    fmu.call(&Functions::GetBoolean, "fmi2GetBoolean", flags_.references.data(), flags_.size(),
             whole_values_.data());
    from_wholes(flags_, values);
  }
}

void Group::from_wholes(const Part& part, double* values) const {
  for (std::size_t k = 0; k < part.size(); ++k) values[part.seats[k].place] = whole_values_[k];
}

void Group::set(Instance& fmu, const double* values, double t) {
  if (!reals_.empty()) {
    for (std::size_t k = 0; k < reals_.size(); ++k) real_values_[k] = values[reals_.seats[k].place];
    fmu.call(&Functions::SetReal, "fmi2SetReal", reals_.references.data(), reals_.size(),
             real_values_.data());
  }
  if (!wholes_.empty()) {
    to_wholes(fmu, wholes_, values, t);
    fmu.call(&Functions::SetInteger, "fmi2SetInteger", wholes_.references.data(), wholes_.size(),
             whole_values_.data());
  }
  if (!flags_.empty()) {
    to_wholes(fmu, flags_, values, t);
    fmu.call(&Functions::SetBoolean, "fmi2SetBoolean", flags_.references.data(), flags_.size(),
             whole_values_.data());
  }
}

void Group::to_wholes(Instance& fmu, Part& part, const double* values, double t) {
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Variable& v = fmu.fmu().description.variables[static_cast<std::size_t>(part.seats[k].variable)];
    const double value = values[part.seats[k].place], whole = std::round(value);
    const double least = std::max<double>(v.min, std::numeric_limits<int>::min());
    const double most = std::min<double>(v.max, std::numeric_limits<int>::max());
    if (!(whole >= least && whole <= most))
      throw Error(ErrorCode::numerical,
                  fmt::format("input '{}' is {} at t = {} s; allowed are whole numbers from {} to {}",
                              printable(v.name, 200), value, t, least, most));
    if (whole != value && fmu.tells_first_of(part.seats[k].variable))
      fmu.log().tell(
          fmt::format("input '{}' is {} at t = {} s, and is rounded to {}, as it is a whole number",
                      printable(v.name, 200), value, t, whole));
    whole_values_[k] = static_cast<int>(whole);
  }
}

}  // namespace tandem::fmi
