// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::scenario {

/// What a rung's run gave: the judged quantities over time by their names in [[ladder.judged]], those it has
/// not left out.
struct RungRun {
  std::string name;
  std::optional<text::TimeTable> table;  ///< none: it failed
  std::string failure;                   ///< why
  double seconds = 0.0;                  ///< processor time of a run; 0: not taken
};

/// A quantity over the rungs of a ladder, from simple to rich. Differences are in the judge's unit, or
/// fractions of the largest magnitude, or of the rms, in the richest; NaN of a rung that failed or has no
/// such quantity.
struct LadderColumn {
  LadderQuantity judged;
  std::vector<double> from_richest, to_next;  ///< the richest has no next: 0
  std::vector<double> shift;  ///< [s]: by how much a rung is later than the richest, of what is judged so
};

/// `factor`: from the unit of the output to that of the judge. Throws Error if the richest has failed or has
/// no such quantity.
LadderColumn ladder_column(const std::vector<RungRun>& runs, const LadderQuantity& judged, double factor);

/// What the rungs say. A rung meets the tolerances if its difference from the richest is within that of each
/// quantity.
struct LadderVerdict {
  std::size_t simplest = 0;          ///< that meets them; the last, if no other does
  bool next_changes = true;          ///< whether the next richer differs from it by more than a tolerance
  std::vector<std::size_t> useless;  ///< for each quantity a simpler one is as near to the richest
  std::vector<std::size_t> worse;    ///< richer than `simplest`, and yet beyond a tolerance
};
/// At least one column.
LadderVerdict ladder_verdict(const std::vector<LadderColumn>& columns);

/// A table of the rungs and the verdict in sentences.
std::string ladder_text(const std::vector<RungRun>& runs, const std::vector<LadderColumn>& columns);

/// Rows of ladder.csv, one for each rung (in quotes) and quantity. Units are "1" for fractions, seconds are
/// empty if not taken; status ok, absent (no such quantity) or failed.
inline constexpr const char* ladder_header =
    "rung,quantity,unit,norm,difference,to_next,tolerance,shift,seconds,status";
std::string ladder_rows(const std::vector<RungRun>& runs, const std::vector<LadderColumn>& columns);

}  // namespace tandem::scenario
