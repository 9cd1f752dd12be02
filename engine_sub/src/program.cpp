// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compile/sort.hpp"
#include "math_functions.hpp"
#include "past.hpp"

namespace tandem::engine {
namespace {

double power_series(const double* c, int degree, double x) {
  double sum = c[degree];
  for (int k = degree - 1; k >= 0; --k) sum = sum * x + c[k];
  return sum;
}

double clamped(double mode, double x, const double* limits) {
  return mode < 0.0 ? limits[0] : mode > 0.0 ? limits[1] : x;
}

double beyond_dead_zone(double mode, double x, const double* limits) {
  return mode < 0.0 ? x - limits[0] : mode > 0.0 ? x - limits[1] : 0.0;
}

double side(double x, const double* limits) { return x < limits[0] ? -1.0 : x > limits[1] ? 1.0 : 0.0; }

}  // namespace

std::string Program::not_finite(const double* signals, int last) const {
  const auto finite = [signals](int slot) { return std::isfinite(signals[slot]); };
  for (int k = 0; k < last; ++k) {
    const Operation& o = operations[static_cast<std::size_t>(k)];
    const auto from = reads(o);
    if (!finite(o.out) && std::all_of(from.begin(), from.end(), finite))
      return fmt::format("{} gives {}", named(signal_blocks[static_cast<std::size_t>(o.out)]),
                         signals[o.out]);
  }
  return "";
}

bool Program::jumps() const {
  return std::any_of(courses.begin(), courses.end(), [](const Course& c) { return c.jumps; });
}

void Program::row(const double* values, double* y) const {
  for (const int slot : outputs) *y++ = values[slot];
  for (const int slot : output_rates) *y++ = slot < 0 ? 0.0 : values[slot];
}

std::string Program::named(const std::string& block) const {
  const auto place = places.find(block);
  const bool is_known = place != places.end() && !place->second.empty();
  return "block '" + block + "'" + (is_known ? " (" + place->second + ")" : "");
}

void Program::run(  // NOLINT(readability-function-size): one switch over all operations
    double* s, int first, int last) const {
  using enum Operation::Code;
  for (const Operation *at = operations.data() + first, *end = operations.data() + last; at != end; ++at) {
    const Operation& o = *at;
    const double* const p = parameters.data() + o.parameter;
    double& out = s[o.out];
    switch (o.code) {
      case linear:
        out = p[0] + p[1] * s[o.a];
        break;
      case sum:
        out = p[0] * s[o.a] + p[1] * s[o.b];
        break;
      case add:
        out += p[0] * s[o.a];
        break;
      case product:
        out = s[o.a] * s[o.b];
        break;
      case quotient:
        out = s[o.a] / s[o.b];
        break;
      case polynomial:
        out = power_series(p, o.b, s[o.a]);
        break;
      case function:
        out = functions[static_cast<std::size_t>(o.b)].call(s[o.a]);
        break;
      case function2:
        out = functions2[static_cast<std::size_t>(o.more)].call(s[o.a], s[o.b]);
        break;
      case curve:
        out = curves[static_cast<std::size_t>(o.b)](s[o.a]);
        break;
      case data:
        out = this->data[static_cast<std::size_t>(o.b)].value(static_cast<std::size_t>(s[o.more]), s[o.a]);
        break;
      case surface:
        out = surfaces[static_cast<std::size_t>(o.more)](s[o.a], s[o.b]);
        break;
      case select:
        out = s[o.more] > 0.0 ? s[o.a] : s[o.b];
        break;
      case clamp:
        out = clamped(s[o.more], s[o.a], p);
        break;
      case dead_zone:
        out = beyond_dead_zone(s[o.more], s[o.a], p);
        break;
      case beyond:
        out = side(s[o.a], p);
        break;
      case compare:
        out = s[o.a] > s[o.b] ? 1.0 : 0.0;
        break;
      case delay:
        out = Past(delays[static_cast<std::size_t>(o.b)], s + o.a).value(s[o.more] - p[0]);
        break;
      case call:
        calls[static_cast<std::size_t>(o.more)](p, o.a < 0 ? nullptr : s + o.a, o.b < 0 ? nullptr : s + o.b,
                                                &out);
        break;
      case leave:
        out = s[o.more] * s[o.a] > 0.0 ? s[o.more] : 0.0;
        break;
    }
  }
}

}  // namespace tandem::engine
