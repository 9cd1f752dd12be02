// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/time_grid.hpp"

#include <string>

#include "number_text.hpp"
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

}  // namespace tandem
