// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/bounds.hpp"

#include <algorithm>
#include <limits>

#include "../number_text.hpp"

namespace tandem {
namespace {
constexpr double largest = std::numeric_limits<double>::max();
}

Bounds::Bounds(const SubsystemInfo& info)
    : outputs_(info.output_size()),
      columns_(static_cast<std::int32_t>(info.row_size() - Samples::header)),
      info_(&info),
      most_(static_cast<std::size_t>(outputs_), largest) {
  find_least();
}

void Bounds::find_least() {
  least_ = largest;
  for (const double most : most_) least_ = std::min(least_, most);
}

void Bounds::watch(double until, double beyond) {
  if (!std::isfinite(beyond)) return;
  learning_ = true, until_ = until, beyond_ = beyond;
  std::fill(most_.begin(), most_.end(), 0.0);
  find_least();
}

void Bounds::settle() {
  learning_ = false;
  for (int k = 0; k < outputs_; ++k) {
    double& most = most_[static_cast<std::size_t>(k)];
    const double nominal = std::abs(scalar_at(info_->outputs, k).port->nominal);
    most = std::min(beyond_ * std::max({most, nominal, 1.0}), largest);
  }
  find_least();
}

void Bounds::check(const std::string& subsystem, double t, std::span<const double> values) {
  if (learning_ && t > until_) settle();
  for (int k = 0; k < outputs_; ++k) {
    double& most = most_[static_cast<std::size_t>(k)];
    const double value = values[static_cast<std::size_t>(k)];
    if (learning_ && std::abs(value) > most) {
      most = std::abs(value);
      find_least();
    }
    if (std::abs(value) <= most) continue;
    throw Diverged("subsystem '" + subsystem + "' diverged: it gave " + scalar_at(info_->outputs, k).name() +
                   " = " + number_text(value) + " at t = " + number_text(t) + " s; allowed is up to " +
                   number_text(most) + ", " + number_text(beyond_) +
                   " (span.diverged_beyond) times the largest of its magnitude in the first hundredth of the "
                   "span, its nominal value and 1");
  }
}

void Bounds::write(ByteWriter& to) const {
  to.put(std::uint8_t{learning_});
  to.put_list(most_);
}

void Bounds::read(ByteReader& from) {
  learning_ = from.take<std::uint8_t>() != 0;
  from.take_list(most_);
  if (!std::all_of(most_.begin(), most_.end(), [](double m) { return m >= 0.0 && m <= largest; }))
    from.refuse("has bounds of outputs that are not finite numbers from 0 on");
  find_least();
}

}  // namespace tandem
