// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "tandem/mbs/mechanism/elements.hpp"
#include "tandem/time_series.hpp"

namespace tandem::mbs {

/// c0 + c1 t + c2 t^2 + ...
std::function<InputValue(double)> polynomial(std::vector<double> coefficients);

/// mean + amplitude sin(2 pi frequency t + phase), frequency in Hz, phase in rad.
struct Sine {
  double amplitude, frequency, phase = 0.0, mean = 0.0;
};
std::function<InputValue(double)> sine(const Sine& s);

/// Data. Where nothing is known of them it throws Error (TimeSeries::require); the acceleration of straight
/// pieces is 0.
std::function<InputValue(double)> data(TimeSeries series);

}  // namespace tandem::mbs
