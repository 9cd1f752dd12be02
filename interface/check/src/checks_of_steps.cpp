// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "checks.hpp"
#include "number_text.hpp"

namespace tandem::checks {
namespace {

void take_all_that_fit(const Subject& of) {
  Instance it(of);
  for (const double steps : {0.5, 1.5, 3.25, 10.0}) {
    const double limit = it.ahead(steps);
    it.go_to(limit);
    const std::string where = "advance up to " + number_text(limit) + " s";
    require(
        !it.tolerance().before(limit, it.clock.time),
        where + " went on to t = " + number_text(it.clock.time) + " s; allowed is no step past the limit");
    require(it.tolerance().before(limit, it.clock.next_time),
            where + " returned though the next step ends at t = " + number_text(it.clock.next_time) +
                " s; allowed is to take it");
    require(it.clock.stop == Stop::limit,
            where + " says that it stopped for another reason; allowed is the limit");
  }
}

void leave_what_does_not_fit(const Subject& of) {
  Instance it(of);
  const Clock before = it.clock;
  it.advance(it.ahead(0.5));
  require(it.rows.size() == 1 && it.clock.time == before.time && it.clock.next_time == before.next_time,
          "it moved to t = " + number_text(it.clock.time) + " s, next " + number_text(it.clock.next_time) +
              " s, where half a step was allowed; allowed is to stay at " + number_text(before.time) +
              " s, next " + number_text(before.next_time) + " s");
}

void give_a_sample_a_step(const Subject& of) {
  Instance it(of);
  const double end = it.ahead(23.5);
  for (std::size_t count = 2; it.clock.next_time < end; ++count) {
    it.advance(it.clock.next_time);
    require(it.can().events || it.rows.size() == count, "there are " + std::to_string(it.rows.size()) +
                                                            " samples after " + std::to_string(count - 1) +
                                                            " steps; allowed is " + std::to_string(count));
  }
  require_same(it.rows, in_one_call(of, end), "step by step");
}

void let_times_rise(const Subject& of) {
  Instance it(of);
  it.advance(it.ahead(100.5));
  for (std::size_t k = 1; k < it.rows.size(); ++k) {
    const double before = it.rows[k - 1][0], now = it.rows[k][0];
    require(now > before || (it.rows[k][1] == 1.0 && now == before),
            "a sample at t = " + number_text(now) + " s comes after one at " + number_text(before) +
                " s; allowed are times that rise, or a jump at the same time");
  }
}

void return_without_room(const Subject& of) {
  Instance it(of);
  const double end = it.ahead(20.5);
  it.advance(end, false, 2);
  require(it.can().events || (it.clock.stop == Stop::samples_full && it.rows.size() == 3),
          "with room for 2 samples it gave " + std::to_string(it.rows.size() - 1) +
              " and another reason to stop; allowed is 2 and samples_full");
  const Rows expected = in_one_call(of, end);
  for (const std::int64_t room : {1, 2, 3, 7}) {
    if (room < 2 && it.can().events) continue;  // two samples at each
    Instance other(of);
    other.go_to(end, false, room);
    require_same(other.rows, expected, "with room for " + std::to_string(room) + " samples a call");
  }
}

void land_on_its_grid(const Subject& of) {
  Instance it(of);
  if (!it.can().lands) throw LeftOut("it does not say that it lands");
  const double limit = it.ahead(4.37), node = in_one_call(of, it.ahead(5.5)).back()[0];
  it.go_to(limit, true);
  require(it.clock.time == limit, "it landed at t = " + number_text(it.clock.time) + " s; allowed is " +
                                      number_text(limit) + ", exactly");
  if (it.can().chooses_step) return;
  require(it.clock.next_time == node,
          "after it has landed its next step ends at t = " + number_text(it.clock.next_time) +
              " s; allowed is " + number_text(node) + ", the node of its grid");
  it.advance(node);
  const Clock grid = it.clock;
  it.advance(grid.next_time, true);
  require(grid.time == node && it.clock.time == grid.next_time, "it left its grid after it had landed");
}

void land_without_room(const Subject& of) {
  Instance it(of);
  if (!it.can().lands) throw LeftOut("it does not say that it lands");
  const double limit = it.ahead(4.37);
  const std::int64_t room = it.can().events ? 2 : 1;
  it.go_to(limit, true, room);
  require_same(it.rows, in_one_call(of, limit, true),
               "landing with room for " + std::to_string(room) + " sample a call");
}

}  // namespace

const std::vector<Check> steps = {
    {"advance takes all the steps that fit and no other", take_all_that_fit},
    {"a step that does not fit is not taken", leave_what_does_not_fit},
    {"each step gives one sample, and one by one they are the same", give_a_sample_a_step},
    {"times rise", let_times_rise},
    {"it returns early without room and goes on with the same bits", return_without_room},
    {"it lands exactly and keeps its grid", land_on_its_grid},
    {"landing returns early without room, too", land_without_room}};

}  // namespace tandem::checks
