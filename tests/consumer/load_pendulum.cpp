// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// load_pendulum LIBRARY: the mechanism of pendulum.toml from the library that it was made into.
#include <cmath>
#include <cstdio>
#include <vector>

#include "tandem/shared_library/shared_library.hpp"

int main(int, char** words) {
  const auto pendulum = tandem::load_subsystem(words[1], tandem::default_entry, "step=1e-3");
  constexpr std::int64_t room = 1001, stride = tandem::Samples::header + 3;  // x and two derivatives
  std::vector<double> rows(room * stride);
  tandem::Samples samples(rows.data(), stride, room);
  pendulum->initialize(0.0, 1.0, {}, samples);
  pendulum->advance(1.0, true, {}, samples);
  // x = 1 mm cos(w t), w^2 = 3 g / (2 l), to 5e-9 m (pendulum.cpp).
  const double error = std::abs(samples.values(room - 1)[0] - 1e-3 * std::cos(std::sqrt(1.5 * 9.81)));
  std::printf("pendulum from its library after 1 s: error %.1e m\n", error);
  return error < 5e-9 ? 0 : 1;
}
