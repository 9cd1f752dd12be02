// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tandem/error.hpp"

namespace tandem::kart {

Truth truth(const Scene& scene, const std::string& level) {
  Truth t{couple(scene, {level, 1}, better_scheme), couple(scene, {level, 1}, thesis_scheme, true)};
  for (const Course* course : {&t.better, &t.thesis})
    if (!course->failure.empty())
      throw Error(ErrorCode::numerical, "level " + level + ", a reference of 0.1 ms: " + course->failure);
  return t;
}

bool stays_near(const std::vector<double>& torque, const std::vector<double>& reference) {
  const auto [low, high] = std::minmax_element(reference.begin(), reference.end());
  const double margin = 0.5 * (*high - *low);
  return std::all_of(torque.begin(), torque.end(),
                     [&](double t) { return t >= *low - margin && t <= *high + margin; });
}

const Course& Judge::replayed(int ratio, bool mean) {
  for (const Replay& r : replays_)
    if (r.ratio == ratio && r.mean == mean) return r.course;
  replays_.push_back({ratio, mean, replay(scene_, {level_, ratio}, truth_.better.torque, mean)});
  return replays_.back().course;
}

Outcome Judge::judge(int ratio, const Scheme& scheme, bool profile) {
  return compare(couple(scene_, {level_, ratio}, scheme, profile), ratio, scheme.to_slow == "mean");
}

Outcome Judge::judge_thesis() { return compare(truth_.thesis, 1, false); }

Outcome Judge::compare(Course course, int ratio, bool mean) {
  Outcome o{std::move(course), {}, {}, {}, {}, true};
  if (!o.course.failure.empty()) return o;
  const Course& alone = replayed(ratio, mean);
  o.from_better = difference(o.course, truth_.better);
  o.from_thesis = difference(o.course, truth_.thesis);
  o.integrator = difference(alone, truth_.better);
  o.coupling = difference(o.course, alone);
  o.stable = stays_near(o.course.torque, truth_.better.torque);
  return o;
}

std::vector<Scheme> schemes() {
  std::vector<Scheme> all = {thesis_scheme};
  const auto lagrange = [](int degree) { return fmt::format("lagrange{}", degree); };
  for (int degree = 0; degree <= 3; ++degree) all.push_back({"fastest-first", lagrange(degree), "lagrange0"});
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (int to_fast = 0; to_fast <= 3; ++to_fast)
      for (int to_slow = 0; to_slow <= 3; ++to_slow) {
        const bool thesis = std::string(schedule) == "fastest-first"
                                ? to_slow == 0
                                : std::string(schedule) == "slowest-first" && to_fast == 0 && to_slow == 0;
        if (!thesis) all.push_back({schedule, lagrange(to_fast), lagrange(to_slow)});
      }
  for (const char* to_fast : {"lagrange0", "lagrange1", "lagrange2", "lagrange3", "hermite",
                              "least_squares1_2", "least_squares2_2"})
    all.push_back({"fastest-first", to_fast, "mean"});
  for (const char* to_fast : {"lagrange1", "hermite"})
    all.push_back({"fastest-first", to_fast, "matched_hold"});
  return all;
}

namespace {

std::string number(double value) { return fmt::format("{:.5g}", value); }

}  // namespace

std::string multirate_row(const std::string& level, int ratio, double seconds_of_ratio_one,
                          const Outcome& o) {
  const Course& c = o.course;
  const std::string begin =
      fmt::format("{},{},{:.4g},{:.4g},{:.4g},{:.4f},", level, ratio, c.seconds,
                  seconds_of_ratio_one / c.seconds, t_stop / c.seconds, c.coordinator_share);
  if (!c.failure.empty()) return begin + ",,,,,failed";
  return begin + fmt::format("{},{},{},{},{},{}", number(o.from_better.largest),
                             number(o.from_thesis.largest), number(o.from_better.rms),
                             number(o.integrator.largest), number(o.coupling.largest), o.status());
}

std::string shares_row(const std::string& level, int ratio, const Course& c) {
  return fmt::format("{},{},{:.4f},{:.4f},{:.4f}", level, ratio, c.kart_share, c.engine_share,
                     c.coordinator_share);
}

std::string multirate_line(const std::string& level, int ratio, double seconds_of_ratio_one,
                           const Outcome& o) {
  const Course& c = o.course;
  const std::string difference =
      c.failure.empty() ? fmt::format("{:.2g}° ({:.1g}°)", o.from_better.largest, o.from_better.rms)
                        : "failed";
  return fmt::format("| {} | {} | {:.2g} | {:.3g} | {:.3g} | {:.2g} % | {:.2g} % | {:.2g} % | {} |\n", level,
                     ratio, c.seconds, seconds_of_ratio_one / c.seconds, t_stop / c.seconds,
                     100.0 * c.kart_share, 100.0 * c.engine_share, 100.0 * c.coordinator_share, difference);
}

std::string scheme_row(const std::string& level, int ratio, const Scheme& scheme, const Outcome& o) {
  const std::string begin =
      fmt::format("{},{},{},{},{},", level, ratio, scheme.schedule, scheme.to_fast, scheme.to_slow);
  if (!o.course.failure.empty()) return begin + fmt::format(",,,{:.4g},failed", o.course.seconds);
  return begin + fmt::format("{},{},{},{:.4g},{}", number(o.from_better.largest),
                             number(o.integrator.largest), number(o.coupling.largest), o.course.seconds,
                             o.status());
}

std::vector<Scheme> work_schemes() {
  std::vector<Scheme> all = {thesis_scheme};
  for (const char* to_fast : {"lagrange0", "lagrange1", "lagrange2", "lagrange3"})
    all.push_back({"fastest-first", to_fast, "lagrange0"});
  for (const char* to_fast : {"lagrange0", "lagrange1", "hermite", "least_squares1_2"})
    all.push_back({"fastest-first", to_fast, "mean"});
  return all;
}

std::string work_row(Judge& judge, int ratio, const Scheme& scheme) {
  const Outcome first = judge.judge(ratio, scheme, false);
  const std::string begin =
      fmt::format("{},{},{},{},{},", judge.level(), ratio, scheme.schedule, scheme.to_fast, scheme.to_slow);
  if (!first.course.failure.empty()) return begin + ",,failed";
  double seconds = first.course.seconds;
  if (seconds < 2.0) seconds = std::min(seconds, judge.judge(ratio, scheme, false).course.seconds);
  return begin + fmt::format("{},{:.4g},{}", number(first.from_better.largest), seconds, first.status());
}

}  // namespace tandem::kart
