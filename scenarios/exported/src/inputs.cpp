// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/inputs.hpp"

#include <algorithm>
#include <string>

#include "tandem/error.hpp"

namespace tandem::exported {

static int degree_below(const Segment& s, int most) {
  while (--most > 0 && s.c[most] == 0.0) {
  }
  return most;
}

void Inputs::set_derivative(int input, int order, double value) {
  if (order < 1 || order > highest_order)
    throw Error(ErrorCode::invalid_argument, "the derivative of order " + std::to_string(order) +
                                                 " of an input is given; allowed are orders from 1 to " +
                                                 std::to_string(highest_order));
  Rates& rates = rates_[static_cast<std::size_t>(input)];
  rates.of[order - 1] = value;
  rates.order = std::max(rates.order, order);
}

void Inputs::line(std::size_t input, double begin, Segment& to) const {
  if (!extrapolates_ || !has_before_ || !(begin > begin_before_)) return;
  to.c[1] = (now_[input] - before_[input]) / (begin - begin_before_);
}

int Inputs::give_rates(std::size_t input, Segment& to) const {
  double factorial = 1.0;
  for (int n = 1; n <= rates_[input].order; ++n)
    to.c[n] = rates_[input].of[n - 1] / (factorial *= n) + 0.0;  // -0.0 would mark a jump
  return rates_[input].order;
}

std::span<const Signal> Inputs::over(double begin, double end) {
  signals_.clear();
  for (std::size_t k = 0; k < now_.size(); ++k) {
    Segment& segment = segments_[k] = {};
    segment.origin = begin, segment.end = end, segment.c[0] = now_[k];
    if (rates_[k].order == 0) line(k, begin, segment);
    const int order = give_rates(k, segment);
    signals_.emplace_back(&segment, 1, std::max(order, segment.c[1] != 0.0 ? 1 : 0));
  }
  return signals_;
}

std::span<const Signal> Inputs::jumped(double t) {
  signals_.clear();
  for (std::size_t k = 0; k < now_.size(); ++k) {
    Segment& segment = segments_[k];
    Segment now{t, t, {}};
    add_shifted(segment, t, now.c);
    segment = now, segment.c[0] = now_[k];
    if (rates_[k].order > 0) std::fill_n(segment.c + 1, highest_order, 0.0);
    give_rates(k, segment);
    mark_jump(segment, true);
    signals_.emplace_back(&segment, 1, degree_below(segment, highest_order));
  }
  return signals_;
}

void Inputs::step_done(double begin) {
  before_ = now_;
  begin_before_ = begin;
  has_before_ = true;
  for (Rates& rates : rates_) rates = {};
}

void Inputs::write(ByteWriter& to) const {
  to.put_list(now_);
  to.put_list(before_);
  to.put(begin_before_);
  to.put(std::uint8_t{has_before_});
  to.put(std::uint8_t{extrapolates_});
  for (const Rates& rates : rates_) {
    to.put(std::int32_t{rates.order});
    to.put_doubles(rates.of);
  }
  for (const Segment& segment : segments_) to.put(segment.origin), to.put_doubles(segment.c);
}

void Inputs::read(ByteReader& from) {
  from.take_list(now_);
  from.take_list(before_);
  begin_before_ = from.take<double>();
  has_before_ = from.take<std::uint8_t>() != 0;
  extrapolates_ = from.take<std::uint8_t>() != 0;
  for (Rates& rates : rates_) {
    rates.order = from.take<std::int32_t>();
    if (rates.order < 0 || rates.order > highest_order) from.refuse("an order of derivatives is none");
    from.take_doubles(rates.of);
  }
  for (Segment& segment : segments_) segment.origin = from.take<double>(), from.take_doubles(segment.c);
}

}  // namespace tandem::exported
