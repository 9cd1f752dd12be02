// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "derived_outputs.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {

DerivedOutputs::DerivedOutputs(const Description& description, const std::vector<Seat>& seats)
    : seats_(seats), orders_(seats.size(), 1) {
  std::size_t size = 0;
  for (const Seat& seat : seats) {
    references_.push_back(description.at(seat.variable).reference);
    size += static_cast<std::size_t>(seat.size);
  }
  values_.resize(size);
}

void DerivedOutputs::try_each(Instance& fmu) {
  const auto refuse = [&](std::size_t k, const std::string& why) {
    throw Error(ErrorCode::numerical,
                "output '" + printable(fmu.fmu().description.at(seats_[k].variable).name, 200) +
                    "' has no derivative at the start (" + why + "); allowed is derivatives=0");
  };
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    const std::span values = std::span(values_).first(static_cast<std::size_t>(seats_[k].size));
    try {
      fmu.get_output_derivatives({&references_[k], 1}, {&orders_[k], 1}, values);
    } catch (const Error& error) {
      refuse(k, error.what());
    }
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
      refuse(k, "it is no finite number");
  }
}

void DerivedOutputs::get(Instance& fmu, double* values) {
  if (seats_.empty()) return;
  fmu.get_output_derivatives(references_, orders_, values_);
  auto from = values_.cbegin();
  for (const Seat& seat : seats_) {
    std::copy_n(from, seat.size, values + seat.place);
    from += seat.size;
  }
}

}  // namespace tandem::fmi
