// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tandem::engine_linkage {
namespace {

/// The linkage's speed comes with its derivative, the engine's torque without; a mean needs an engine that is
/// ahead.
std::vector<Scheme> schemes() {
  std::vector<Scheme> all;
  const auto lagrange = [](int degree) { return fmt::format("lagrange{}", degree); };
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    for (int degree = 0; degree <= 4; ++degree) all.push_back({schedule, lagrange(degree), lagrange(degree)});
    for (int degree = 0; degree <= 1; ++degree) all.push_back({schedule, "hermite", lagrange(degree)});
  }
  for (int degree = 0; degree <= 4; ++degree) all.push_back({"fastest-first", lagrange(degree), "mean"});
  for (const char* to_fast : {"hermite", "least_squares1_2", "least_squares2_2"})
    all.push_back({"fastest-first", to_fast, "mean"});
  return all;
}

std::string key(const Case& c) {
  return fmt::format("{},{},{},{},{},", c.loops, c.scheme.schedule, c.scheme.to_fast, c.scheme.to_slow,
                     c.step_ratio);
}

const char* status(const Outcome& o) { return o.stable ? "stable" : "unstable"; }

}  // namespace

std::vector<Case> sweep_cases() {
  std::vector<Case> cases;
  for (const Scheme& scheme : schemes())
    for (const double ratio : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) cases.push_back({scheme, 1, 1e-4, ratio});
  return cases;
}

std::vector<Case> equal_step_cases() {
  std::vector<Case> cases;
  for (const Scheme& scheme : schemes()) cases.push_back({scheme, 1, 1e-3, 1.0});
  return cases;
}

std::vector<Case> size_cases() {
  std::vector<Case> cases;
  for (const int loops : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000})
    cases.push_back({{"slowest-first", "lagrange3", "lagrange3"}, loops, 1e-3, 1.0});
  return cases;
}

std::string scheme_row(const Case& c, const Outcome& o) {
  if (!o.stable) return key(c) + fmt::format(",,{},{}", o.exchanges, status(o));
  return key(c) + fmt::format("{:.4e},{:.4e},{},{}", o.largest, o.rms, o.exchanges, status(o));
}

std::string work_row(const Case& c, const Outcome& o, const engine::Description& engine) {
  if (!o.stable) return key(c) + fmt::format(",,{}", status(o));
  const double seconds = std::min(time_case(c, engine, t_stop).total, time_case(c, engine, t_stop).total);
  return key(c) + fmt::format("{:.4e},{:.4e},{}", o.largest, seconds, status(o));
}

std::string elapsed_row(const Case& c, const engine::Description& engine) {
  constexpr double part = 0.1;
  Elapsed best = time_case(c, engine, part * t_stop);
  for (int k = 1; k < 3; ++k)
    if (const Elapsed again = time_case(c, engine, part * t_stop); again.total < best.total) best = again;
  const double coordinator = best.total - best.engine - best.linkage;
  return fmt::format("{},{},{:.4e},{:.4e},{:.4e},{:.4e},{:.4f},{:.1f},{:.3g}", c.loops, 2 * c.loops + 3,
                     best.total / part, best.engine / part, best.linkage / part, coordinator / part,
                     coordinator / best.total, 1e9 * coordinator / static_cast<double>(best.exchanges),
                     part * t_stop / best.total);
}

}  // namespace tandem::engine_linkage
