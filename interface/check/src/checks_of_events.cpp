// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "checks.hpp"
#include "number_text.hpp"

namespace tandem::checks {
namespace {

constexpr double length = 100.5;  // own steps

bool is_jump(const std::vector<double>& row) { return row[1] == 1.0; }

void give_jumps_as_two_rows(const Subject& of) {
  Instance it(of);
  it.go_to(it.ahead(length));
  for (std::size_t k = 0; k < it.rows.size(); ++k)
    require(!is_jump(it.rows[k]) || (k > 0 && it.rows[k - 1][0] == it.rows[k][0]),
            "a sample at t = " + number_text(it.rows[k][0]) +
                " s is marked as a jump and stands alone; allowed is one before it at that time, with the "
                "values just before the jump");
}

/// The last row of a call is a jump where it says that it stopped at an event, and no other row is.
void stop_at_events(const Subject& of) {
  Instance it(of);
  if (!it.can().events) return;
  const double end = it.ahead(length);
  while (it.clock.next_time < end && it.clock.stop != Stop::finished) {
    const std::size_t before = it.rows.size();
    it.call_once(end);
    for (std::size_t k = before; k + 1 < it.rows.size(); ++k)
      require(!is_jump(it.rows[k]) || it.rows[k][0] == it.rows[before - 1][0],
              "it went on from the jump at t = " + number_text(it.rows[k][0]) +
                  " s in the same call; allowed is to return there");
    require(it.clock.stop != Stop::event || is_jump(it.rows.back()),
            "it says that it stopped at an event, but its newest sample, at t = " +
                number_text(it.rows.back()[0]) + " s, is no jump");
  }
}

}  // namespace

const std::vector<Check> events = {
    {"a jump is two samples at one time, the second marked", give_jumps_as_two_rows},
    {"one with events returns at each of them", stop_at_events}};

}  // namespace tandem::checks
