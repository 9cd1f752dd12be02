// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "split_pendulum/experiment.hpp"

namespace tandem::split_pendulum {

/// The cases of schemes.csv: schedules x displacement x force, least squares, holds and a late force with the
/// rods of the scenario, by both formulations, with no, a quarter and all of the lower rod's mass carried,
/// either side fast; with another ratio of the steps; with rods of equal mass; and both rods in one
/// mechanism. All can be honoured.
std::vector<Case> sweep_cases();

/// A row: largest and rms error [m]; order: log2 of the ratio of the largest error to that with all steps
/// halved; status stable or unstable; why.
inline constexpr const char* schemes_header =
    "formulation,carried_mass,lower_mass,fast,ratio,schedule,to_lower,to_upper,lag,largest_error,rms_error,"
    "order,status,note";
std::string scheme_row(const Case& c);

/// The schemes of limits.csv, those whose displacement has an acceleration, and a row: the largest ratio of
/// masses with which one is stable.
std::vector<Scheme> limit_schemes();
inline constexpr const char* limits_header =
    "formulation,fast,ratio,schedule,to_lower,to_upper,lag,stable_mass_ratio";
std::string limit_row(const Scheme& s);

}  // namespace tandem::split_pendulum
