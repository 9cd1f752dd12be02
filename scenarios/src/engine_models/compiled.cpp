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

double pumped(double N, double P) {
  return std::max(-0.366 + 0.08979 * N * P - 0.0337 * N * P * P + 0.0001 * N * N * P, 0.0);
}

double opening(double theta) { return 2.821 + theta * (-0.05231 + theta * (0.10299 - 0.00063 * theta)); }

void engine_output(const double*, const double* x, const double*, double* y) {
  const double P = x[0], N = x[1];
  y[0] = N, y[1] = P, y[2] = pumped(N, P), y[3] = quotient_of_pressures(P);
}

void engine_rates(const double* p, const double* x, const double* u, double* dx) {
  const double P = x[0], N = x[1], throttle = u[0], load = u[1], burnt = u[2];
  dx[0] = 0.41328 * (opening(throttle) * flow(P, u[3] > 0.0) - pumped(N, P));
  dx[1] = (-39.33 + 406.36 * burnt + (0.0342 - 0.000107 * N) * N - load) / p[0];
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
  engine::CompiledBlock core{.kind = "engine_core",
                             .inputs = {"throttle", "load", "burnt", "unchoked"},
                             .outputs = {"N", "P", "out", "q"},
                             .parameters = {{"J"}},
                             .states = {{"P0"}, {"N0"}},
                             .output = engine_output,
                             .rates = engine_rates,
                             .feedthrough = false};
  engine::CompiledBlock converter{.kind = "converter_core",
                                  .inputs = {"N", "turbine", "fill", "driving", "multiplying"},
                                  .outputs = {"impeller", "output", "slip", "multiplied"},
                                  .output = converter_output};
  return {core, converter};
}

}  // namespace tandem::engine_models
