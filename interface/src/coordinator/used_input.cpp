// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "used_input.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

void UsedInput::push(const Piece& piece) {
  constexpr std::size_t few = 64;
  if (first_ > few && 2 * first_ > pieces_.size()) {
    pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
  pieces_.push_back(piece);
}

/// What is read again beyond the newest sample is the same piece, further on.
void UsedInput::add(const Signal& signal, TimeSpan span) {
  const auto segments = signal.segments();
  from_ = std::min(from_, span.start);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Segment& s = segments[k];
    const bool last = k + 1 == segments.size() || s.end >= span.stop;
    if (!last && s.end <= span.start) continue;
    const bool again = first_ < pieces_.size() && pieces_.back().segment.origin == s.origin &&
                       std::equal(s.c, s.c + TANDEM_MAX_COEFFICIENTS, pieces_.back().segment.c);
    const double until = last ? span.stop : s.end;
    if (again)
      pieces_.back().until = until;
    else
      push({until, s});
    if (last) return;
  }
}

/// A second value of one instant is the one that counts.
void UsedInput::add(double t, double value) {
  from_ = std::min(from_, t);
  if (first_ < pieces_.size() && pieces_.back().until == t)
    pieces_.back().segment.c[0] = value;
  else
    push({t, {t, t, {value}}});
}

void UsedInput::go_back(double t) {
  while (pieces_.size() > first_ + 1 && pieces_[pieces_.size() - 2].until >= t) pieces_.pop_back();
  if (first_ < pieces_.size()) pieces_.back().until = std::min(pieces_.back().until, t);
}

void UsedInput::write(ByteWriter& to) const {
  to.put(from_);
  std::vector<double> numbers;
  for (std::size_t k = first_; k < pieces_.size(); ++k) {
    numbers.insert(numbers.end(), {pieces_[k].until, pieces_[k].segment.origin});
    numbers.insert(numbers.end(), pieces_[k].segment.c, pieces_[k].segment.c + TANDEM_MAX_COEFFICIENTS);
  }
  to.put_list(numbers);
}

void UsedInput::read(ByteReader& from) {
  constexpr std::size_t width = 2 + TANDEM_MAX_COEFFICIENTS;
  from_ = from.take<double>();
  const auto numbers = from.take_list();
  if (numbers.size() % width != 0)
    from.refuse("has " + std::to_string(numbers.size()) + " numbers of an input; allowed are pieces of " +
                std::to_string(width));
  pieces_.clear(), first_ = 0;
  for (std::size_t k = 0; k < numbers.size(); k += width) {
    Piece piece{numbers[k], {numbers[k], numbers[k + 1], {}}};
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(k) + 2, TANDEM_MAX_COEFFICIENTS,
                piece.segment.c);
    pieces_.push_back(piece);
  }
}

}  // namespace tandem
