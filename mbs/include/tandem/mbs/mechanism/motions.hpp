// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/elements.hpp"

namespace tandem::mbs {

/// c0 + c1 t + c2 t^2 + ...
std::function<InputValue(double)> polynomial(std::vector<double> coefficients);

/// mean + amplitude sin(2 pi frequency t + phase), frequency in Hz, phase in rad.
struct Sine {
  double amplitude, frequency, phase = 0.0, mean = 0.0;
};
std::function<InputValue(double)> sine(const Sine& s);

enum class Interpolation {
  linear,  ///< a time that is there twice is a jump; the rate is that of the piece, the acceleration 0
  spline   ///< natural cubic spline: value, rate and acceleration are continuous
};

/// Values over time from points that the caller has. Beyond them it throws Error with the time, `name` and
/// what is allowed. Throws Error for fewer than two points, and for a time twice with a spline.
std::function<InputValue(double)> interpolated(std::vector<double> times, std::vector<double> values,
                                               Interpolation how, const std::string& name);

}  // namespace tandem::mbs
