// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tandem::split_pendulum {
namespace {

/// A mean needs a source that is ahead of its reader.
bool gives_mean(const std::string& schedule, const std::string& fast) {
  return schedule == (fast == "lower" ? "fastest-first" : "slowest-first");
}

constexpr std::array schedules = {"slowest-first", "fastest-first", "parallel"};

/// By what is the same in all of them.
class Schemes {
 public:
  explicit Schemes(const Scheme& like) : like_(like) {}
  void add(const std::string& schedule, const std::string& to_lower, const std::string& to_upper,
           Lag lag = Lag::none) {
    all_.push_back(like_);
    Scheme& s = all_.back();
    s.schedule = schedule, s.to_lower = to_lower, s.to_upper = to_upper, s.lag = lag;
  }
  std::vector<Scheme> take() { return std::move(all_); }

 private:
  Scheme like_;
  std::vector<Scheme> all_;
};

/// Displacement x force. The force gives no derivative, so no Hermite; a displacement of degree 0 or 1 has no
/// acceleration that the lower rod could resist, and is lost with any steps.
void add_pairs(Schemes& to, const std::string& schedule, bool mean) {
  for (const std::string to_lower : {"lagrange2", "lagrange3", "lagrange4", "hermite"}) {
    for (int degree = 0; degree <= 4; ++degree)
      to.add(schedule, to_lower, "lagrange" + std::to_string(degree));
    if (mean) to.add(schedule, to_lower, "mean");
  }
}

/// As in the two-mass test.
void add_least_squares(Schemes& to, const std::string& schedule) {
  for (int degree = 1; degree <= 3; ++degree)
    for (const int extra : {2, 4}) to.add(schedule, fmt::format("least_squares{}_{}", degree, extra), "mean");
}

/// The scenario's force, late.
void add_lags(Schemes& to, const std::string& schedule) {
  for (const std::string to_lower : {"lagrange3", "lagrange4"})
    for (const Lag lag : {Lag::memory, Lag::delay}) to.add(schedule, to_lower, "lagrange1", lag);
}

std::vector<Scheme> schemes(const Scheme& like) {
  Schemes all(like);
  for (const std::string schedule : schedules) {
    const bool mean = gives_mean(schedule, like.fast);
    add_pairs(all, schedule, mean);
    if (mean) add_least_squares(all, schedule);
    add_lags(all, schedule);
  }
  for (const std::string schedule : {"slowest-first", "fastest-first", "staggered"})
    all.add(schedule, "matched_hold", "matched_hold");
  return all.take();
}

/// Of the second degree at least: else the lower rod resists no acceleration, and a mass is missing rather
/// than unstable.
bool has_acceleration(const Scheme& s) { return Reconstruction::parse(s.to_lower).polynomial_degree() >= 2; }

const char* word(Lag lag) { return lag == Lag::none ? "none" : lag == Lag::memory ? "memory" : "delay"; }

std::string one_cell(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), ',', ';');
  return sentence;
}

}  // namespace

std::vector<Case> sweep_cases() {
  std::vector<Case> cases;
  const auto add = [&](const Scheme& like, const Rods& rods) {
    for (const std::string fast : {"lower", "upper"}) {
      Scheme scheme = like;
      scheme.fast = fast;
      for (const Scheme& s : schemes(scheme)) cases.push_back({s, rods});
    }
  };
  for (const double lower_mass : {0.1, 1.0})
    for (const std::string formulation : {"index3", "null_space"})
      cases.push_back({{.schedule = "monolithic", .formulation = formulation, .ratio = 1.0}, {lower_mass}});
  for (const double part : {0.0, 1.0}) add({.formulation = "index3"}, {0.1, part * 0.1});
  for (const double part : {0.0, 0.25, 1.0}) add({}, {0.1, part * 0.1});
  for (const double part : {0.0, 0.25, 1.0}) add({}, {1.0, part});
  add({.ratio = 2.5}, {});
  return cases;
}

std::string scheme_row(const Case& c) {
  const Truth truth(c.rods, t_stop);
  const Scheme& s = c.scheme;
  std::string row =
      fmt::format("{},{},{},{},{},{},{},{},{},", s.formulation, c.rods.carried_mass, c.rods.lower_mass,
                  s.monolithic() ? "" : s.fast, s.ratio, s.schedule, s.to_lower, s.to_upper, word(s.lag));
  const Outcome outcome = run_case(c, truth);
  if (!outcome.stable) return row + ",,,unstable," + one_cell(outcome.note);
  Case finer = c;
  finer.step /= 2.0;
  const Outcome fine = run_case(finer, truth);
  const std::string order =
      fine.stable ? fmt::format("{:.2f}", std::log2(outcome.largest / fine.largest)) : "";
  return row + fmt::format("{:.3e},{:.3e},{},stable,{}", outcome.largest, outcome.rms, order,
                           fine.stable ? "" : "not with half the steps: " + one_cell(fine.note));
}

std::vector<Scheme> limit_schemes() {
  std::vector<Scheme> all;
  for (const std::string formulation : {"index3", "null_space"})
    for (const std::string fast : {"lower", "upper"})
      for (Scheme& s : schemes({.fast = fast, .formulation = formulation}))
        if (has_acceleration(s)) all.push_back(std::move(s));
  return all;
}

std::string limit_row(const Scheme& s) {
  return fmt::format("{},{},{},{},{},{},{},{:.3g}", s.formulation, s.fast, s.ratio, s.schedule, s.to_lower,
                     s.to_upper, word(s.lag), stable_mass_ratio(s));
}

}  // namespace tandem::split_pendulum
