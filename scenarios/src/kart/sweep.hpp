// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kart/experiment.hpp"

namespace tandem::kart {

/// The levels of the kart, from the simplest on.
inline constexpr const char* levels[] = {"point", "plane", "spatial_scalar_spin", "spatial"};

/// What the runs of a level are compared with.
inline const Scheme better_scheme{"fastest-first", "lagrange2", "mean"};
struct Truth {
  Course better;  ///< both sides at 0.1 ms, fastest-first, speeds of degree 2, the torque's mean
  Course thesis;  ///< both sides at 0.1 ms, slowest-first, degree 0 both ways
};
Truth truth(const Scene& scene, const std::string& level);

/// A run and what it differs from. It is unstable if the torque leaves the range that it has in the reference
/// by more than half of that range's width: torque and speed then drive each other up, which the pitch, slow
/// as it is, shows late.
struct Outcome {
  Course course;
  Difference from_better, from_thesis, integrator, coupling;
  bool stable = true;
  /// "failed": a side gave up; "unstable", "ok".
  const char* status() const { return !course.failure.empty() ? "failed" : stable ? "ok" : "unstable"; }
};
/// Whether `torque` stays as near to the range of `reference` as is said above; both have at least a value.
bool stays_near(const std::vector<double>& torque, const std::vector<double>& reference);
/// Replays are kept by the kart's step and whether they take the mean.
class Judge {
 public:
  Judge(const Scene& scene, std::string level)
      : scene_(scene), level_(std::move(level)), truth_(truth(scene, level_)) {}
  const std::string& level() const { return level_; }
  const Truth& reference() const { return truth_; }
  Outcome judge(int ratio, const Scheme& scheme, bool profile);
  /// The thesis' reference.
  Outcome judge_thesis();

 private:
  Outcome compare(Course course, int ratio, bool mean);
  const Course& replayed(int ratio, bool mean);
  struct Replay {
    int ratio;
    bool mean;
    Course course;
  };
  const Scene& scene_;
  std::string level_;
  Truth truth_;
  std::vector<Replay> replays_;
};

/// Table 6.2 of the thesis: slowest-first, degree 0 both ways.
inline constexpr int ratios[] = {1, 5, 10, 50, 100};
inline const Scheme thesis_scheme{"slowest-first", "lagrange0", "lagrange0"};

/// Table 6.3 and beyond, at ratio 100: the thesis' five rows first.
std::vector<Scheme> schemes();

/// Rows of multirate.csv and schemes.csv; pitch in degrees.
inline constexpr const char* multirate_header =
    "level,ratio,seconds,speed_up,real_time_factor,coordinator_share,max_pitch_difference,"
    "max_pitch_difference_thesis,rms_pitch_difference,integrator_part,coupling_part,status";
std::string multirate_row(const std::string& level, int ratio, double seconds_of_ratio_one, const Outcome& o);
/// A row of shares.csv, fractions of the seconds of that row of multirate.csv, and both as a line of a table
/// to read.
inline constexpr const char* shares_header = "level,ratio,kart_share,engine_share,coordinator_share";
std::string shares_row(const std::string& level, int ratio, const Course& course);
inline constexpr const char* multirate_head =
    "| level | ratio | time, s | against ratio 1 | real-time factor | kart | engine | coordinator | "
    "largest (rms) difference of the pitch |\n|---|---|---|---|---|---|---|---|---|\n";
std::string multirate_line(const std::string& level, int ratio, double seconds_of_ratio_one,
                           const Outcome& o);
inline constexpr const char* schemes_header =
    "level,ratio,schedule,to_fast,to_slow,max_pitch_difference,integrator_part,coupling_part,seconds,status";
std::string scheme_row(const std::string& level, int ratio, const Scheme& scheme, const Outcome& o);

/// Speed against accuracy: the thesis' five rows and the better schemes, at these ratios. A row of work.csv:
/// seconds are the least of two runs, from 2 s on of one.
inline constexpr int work_ratios[] = {5, 10, 20, 50, 100};
std::vector<Scheme> work_schemes();
inline constexpr const char* work_header =
    "level,ratio,schedule,to_fast,to_slow,max_pitch_difference,seconds,status";
std::string work_row(Judge& judge, int ratio, const Scheme& scheme);

/// Of the stable runs of a level those whose pitch differs most and least from the reference.
class Extremes {
 public:
  void add(const Scheme& scheme, const Outcome& outcome);
  struct Extreme {
    Scheme scheme;
    Outcome outcome;
  };
  const std::optional<Extreme>& worst() const { return worst_; }
  const std::optional<Extreme>& best() const { return best_; }

 private:
  std::optional<Extreme> worst_, best_;
};

/// Rows of traces.csv: the reference of a level, its worst and its best scheme, every 10 ms; cells of what a
/// level has not are empty.
std::string traces_header();
std::string trace_rows(const Judge& judge, const Extremes& extremes);

}  // namespace tandem::kart
