// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "arguments.hpp"

namespace tandem::engine {

/// What the keys `interpolation` and `beyond` say.
inline TimeSeries::How joining(Arguments& a) {
  return {static_cast<TimeSeries::Between>(a.word("interpolation")),
          static_cast<TimeSeries::Beyond>(a.word("beyond"))};
}

/// The block's output is data over time, and refused where nothing is known of them.
inline void define_data(Lowering& to, Arguments& a, TimeSeries data) {
  const double begin = data.begin(), end = data.end();
  const int y = to.data(std::move(data));
  to.range(y, {to.time(), begin, end, a.owner(), "time"});
  to.define("", y);
}

}  // namespace tandem::engine
