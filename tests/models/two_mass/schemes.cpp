// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/experiment.hpp"

namespace tandem::two_mass {
namespace {

std::string lagrange(int degree) { return "lagrange" + std::to_string(degree); }

void add_lagrange(std::vector<Scheme>& schemes, const std::string& schedule, bool pairs) {
  for (int to_fast = 0; to_fast <= 4; ++to_fast)
    for (int to_slow = 0; to_slow <= 4; ++to_slow)
      if (pairs || to_fast == to_slow) schemes.push_back({schedule, lagrange(to_fast), lagrange(to_slow)});
}

/// The thesis' smoothing: the slow side reads the mean of the fast side over its step.
void add_smoothing(std::vector<Scheme>& schemes) {
  for (int degree = 0; degree <= 4; ++degree) schemes.push_back({"fastest-first", lagrange(degree), "mean"});
  for (int degree = 1; degree <= 3; ++degree)
    for (const int extra : {2, 4})
      schemes.push_back(
          {"fastest-first", "least_squares" + std::to_string(degree) + "_" + std::to_string(extra), "mean"});
}

}  // namespace

std::vector<Scheme> sweep_schemes(bool pairs) {
  std::vector<Scheme> schemes;
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    add_lagrange(schemes, schedule, pairs);
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    schemes.push_back({schedule, "hermite", "hermite"});
  for (const char* schedule : {"slowest-first", "fastest-first", "staggered"})
    schemes.push_back({schedule, "matched_hold", "matched_hold"});
  add_smoothing(schemes);
  return schemes;
}

const std::vector<double>& sweep_ratios() {
  static const std::vector<double> ratios = {
      1.5,  1.7721, 2,  2.3,  2.7,  3,  3.7,  5,  6.4,  8,   10,    12.6, 15,  17.3, 20,  22.5,
      25,   27.1,   30, 30.7, 33.3, 35, 37.5, 40, 42.7, 45,  47.9,  50,   55,  57.3, 60,  65,
      66.6, 70,     75, 77.7, 80,   85, 90,   95, 99.5, 100, 123.4, 150,  200, 300,  500, 1000};
  return ratios;
}

}  // namespace tandem::two_mass
