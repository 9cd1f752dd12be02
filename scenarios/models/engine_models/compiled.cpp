// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_models/compiled.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::engine_models {
namespace {

double quotient_of_pressures(double P) { return std::min(P, 1.0 / P); }

/// g(P), backwards above 1 bar.
double flow(double P, bool unchoked) {
  const double q = quotient_of_pressures(P);
  double g = 1.0;
  if (unchoked) g = q > 0.9999 ? 199.9899997499875 * (1.0 - q) : 2.0 * std::sqrt(q * (1.0 - q));
  return P < 1.0 ? g : -g;
}

double opening(double theta) { return 2.821 + theta * (-0.05231 + theta * (0.10299 - 0.00063 * theta)); }

void manifold_output(const double*, const double* x, const double*, double* y) {
  y[0] = x[0], y[1] = quotient_of_pressures(x[0]);
}

void manifold_rates(const double*, const double* x, const double* u, double* dx) {
  dx[0] = 0.41328 * (opening(u[0]) * flow(x[0], u[2] > 0.0) - u[1]);
}

void cylinders_output(const double*, const double*, const double* u, double* y) {
  const double N = u[0], P = u[1];
  y[0] = std::max(-0.366 + 0.08979 * N * P - 0.0337 * N * P * P + 0.0001 * N * N * P, 0.0);
}

void converter_output(const double*, const double*, const double* u, double* y) {
  const double N = std::max(u[0], 1.0), turbine = std::max(u[1], 0.0), fill = u[2];
  const bool driving = u[3] > 0.0, multiplying = u[4] > 0.0;
  const double fast = driving ? N : turbine, ratio = (driving ? turbine : N) / fast,
               cube = ratio * ratio * ratio;
  const double grip = 5.34e-4 * (1.0 - cube * cube) * fast * fast * fill;
  y[0] = driving ? grip : -grip;
  y[2] = N - turbine;
  y[3] = 2.2 - 1.4 * ratio;
  y[1] = driving && multiplying ? y[0] * y[3] : y[0];
}

}  // namespace

std::vector<engine::CompiledBlock> compiled_kinds() {
  engine::CompiledBlock manifold{.kind = "manifold_core",
                                 .inputs = {"throttle", "out", "unchoked"},
                                 .outputs = {"P", "q"},
                                 .states = {{"P0"}},
                                 .output = manifold_output,
                                 .rates = manifold_rates,
                                 .feedthrough = false};
  engine::CompiledBlock cylinders{
      .kind = "cylinders_core", .inputs = {"N", "P"}, .outputs = {"out"}, .output = cylinders_output};
  engine::CompiledBlock converter{.kind = "converter_core",
                                  .inputs = {"N", "turbine", "fill", "driving", "multiplying"},
                                  .outputs = {"impeller", "output", "slip", "multiplied"},
                                  .output = converter_output};
  return {manifold, cylinders, converter};
}

}  // namespace tandem::engine_models
