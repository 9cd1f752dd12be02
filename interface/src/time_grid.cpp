// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/time_grid.hpp"

#include <array>
#include <string>

#include "number_text.hpp"
#include "tandem/bytes.hpp"
#include "tandem/error.hpp"

namespace tandem {

TimeGrid::TimeGrid(double t_start, double h)
    : t_start_(t_start), h_(h), time_(t_start), next_(t_start + h), tolerance_(t_start) {
  if (!std::isfinite(t_start) || !std::isfinite(h) || h <= 0.0)
    throw Error(ErrorCode::invalid_argument, "own step " + number_text(h) + " s from t_start " +
                                                 number_text(t_start) +
                                                 " s: both must be finite, the step above 0");
  if (!tolerance_.before(t_start, next_))
    throw Error(ErrorCode::invalid_argument, "own step " + number_text(h) +
                                                 " s is too small to be told from 0 at t_start " +
                                                 number_text(t_start) + " s");
}

void TimeGrid::write(ByteWriter& to) const {
  to.put_doubles(std::array{t_start_, h_, time_});
  to.put(index_);
  to.put(std::uint8_t{whole_});
}

void TimeGrid::read(ByteReader& from) {
  const auto t_start = from.take<double>(), h = from.take<double>(), time = from.take<double>();
  const auto index = from.take<std::int64_t>();
  const bool whole = from.take<std::uint8_t>() != 0;
  if (t_start != t_start_ || h != h_)
    from.refuse("is of own steps of " + number_text(h) + " s from " + number_text(t_start) +
                " s; allowed are those of " + number_text(h_) + " s from " + number_text(t_start_) + " s");
  if (index < 1 || !(whole ? time == node(index - 1) : time > node(index - 1) && time < node(index)))
    from.refuse("stands at t = " + number_text(time) + " s, which is not in its own step " +
                std::to_string(index));
  time_ = time, index_ = index, whole_ = whole;
  next_ = node(index_);
}

}  // namespace tandem
