// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/motions.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace tandem::mbs {
std::function<InputValue(double)> polynomial(std::vector<double> c) {
  return [c = std::move(c)](double t) {
    InputValue m;
    for (std::size_t k = c.size(); k-- > 0;) {
      m.acceleration = m.acceleration * t + 2.0 * m.rate;
      m.rate = m.rate * t + m.value;
      m.value = m.value * t + c[k];
    }
    return m;
  };
}

std::function<InputValue(double)> sine(const Sine& s) {
  const double w = 2.0 * std::numbers::pi * s.frequency;
  return [s, w](double t) {
    const double sine = s.amplitude * std::sin(w * t + s.phase),
                 cosine = s.amplitude * std::cos(w * t + s.phase);
    return InputValue{s.mean + sine, w * cosine, -w * w * sine};
  };
}

std::function<InputValue(double)> data(TimeSeries series) {
  return [series = std::make_shared<const TimeSeries>(std::move(series))](double t) {
    series->require(t);
    const Signal piece(&series->piece(t), 1, series->degree());
    return InputValue{piece.value(t), piece.derivative(t), piece.second_derivative(t)};
  };
}

}  // namespace tandem::mbs
