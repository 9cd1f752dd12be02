// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "engine_linkage/experiment.hpp"

namespace tandem::engine_linkage {

/// One loop, every schedule with every degree and the better schemes: the engine with 0.1 ms, the linkage
/// with 1, 2, 5, 10, 20 and 50 times that.
std::vector<Case> sweep_cases();
/// The same schemes with 1 ms on both sides, as in the thesis.
std::vector<Case> equal_step_cases();
/// Linkages of 1 to 2000 loops, slowest-first with degree 3, 1 ms on both sides.
std::vector<Case> size_cases();

/// A row of schemes.csv and equal_steps.csv: differences in rad/s; status stable or unstable.
inline constexpr const char* schemes_header =
    "loops,schedule,to_fast,to_slow,step_ratio,max_speed_error,rms_speed_error,exchanges,status";
std::string scheme_row(const Case& c, const Outcome& outcome);

/// A row of work.csv: seconds of the whole run, the least of two.
inline constexpr const char* work_header =
    "loops,schedule,to_fast,to_slow,step_ratio,max_speed_error,seconds,status";
std::string work_row(const Case& c, const Outcome& outcome, const engine::Description& engine);

/// A row of elapsed.csv: seconds are of 30 s of motion, from the least of three runs of a tenth of it.
inline constexpr const char* elapsed_header =
    "loops,variables,seconds,engine_seconds,linkage_seconds,coordinator_seconds,coordinator_share,"
    "coordinator_ns_per_exchange,real_time_factor";
std::string elapsed_row(const Case& c, const engine::Description& engine);

}  // namespace tandem::engine_linkage
