// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Advice for a scene of which a part runs itself, beside what its study finds.
#include <gtest/gtest.h>

#include "command.hpp"
#include "tandem/advice/advice.hpp"

namespace tandem::advise_command_tests {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

/// A room with a wall, and a heater that a relay switches: eight cycles, of which the first is seen.
void write_room(const Scratch& folder) {
  folder.write(
      "room.toml",
      "[inputs]\nheat = { unit = 'W' }\n[blocks]\n"
      "rate = { kind = 'sum', inputs = ['heat', 'T', 'wall'], gains = [1e-2, -3e-3, 2e-3] }\n"
      "T = { kind = 'integrator', input = 'rate', initial = 18 }\n"
      "flow = { kind = 'sum', inputs = ['T', 'wall'], gains = [4e-4, -4e-4] }\n"
      "wall = { kind = 'integrator', input = 'flow', initial = 17 }\n[outputs]\nT = { unit = 'K' }\n");
  folder.write("heater.toml",
               "[inputs]\nT = { unit = 'K' }\n[blocks]\n"
               "power = { kind = 'relay', input = 'T', low = 19, high = 21, off = 5, on = 0 }\n"
               "rate = { kind = 'sum', inputs = ['power', 'heat'], gains = [0.05, -0.05] }\n"
               "heat = { kind = 'integrator', input = 'rate' }\n[outputs]\nheat = { unit = 'W' }\n");
  folder.write(
      "s.toml",
      "[subsystems.room]\nsource = 'diagram:room.toml'\nparameters = { step = 5, integrator = 'rk4' }\n"
      "[subsystems.heater]\nsource = 'diagram:heater.toml'\nparameters = { step = 1, integrator = 'rk4' }\n"
      "[[connections]]\nfrom = 'room.T'\nto = 'heater.T'\nreconstruction = 'lagrange2'\n"
      "[[connections]]\nfrom = 'heater.heat'\nto = 'room.heat'\nreconstruction = 'lagrange1'\n"
      "[coordination]\nschedule = 'slowest-first'\n[span]\nstop = 6000\n"
      "[judge]\nquantity = 'room.T'\ntolerance = 1e-3\n");
}

bool is(const advice::Choice& a, const advice::Choice& b) {
  return a.schedule == b.schedule && a.reconstruction == b.reconstruction && a.steps == b.steps;
}

double error_in(const advice::Ranking& all, const advice::Choice& of) {
  for (const advice::Choice& one : all.choices)
    if (is(one, of)) return one.error;
  return 1e300;
}

/// What looks good enough at first is beyond the tolerance twice in the end.
TEST(AdviseCommand, WhatIsWithinTheToleranceIsSoToTheEnd) {
  const Scratch folder;
  write_room(folder);
  const Said said = tandem(folder, {"advise", "s.toml", "--output", "a"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("\nto the end, beside fastest-first, "), std::string::npos) << said.out;
  ASSERT_EQ(tandem(folder, {"sweep", "s.toml", "--output", "t"}).status, 0);
  const auto first = advice::ranking(folder.path() / "a/schemes.csv"),
             last = advice::ranking(folder.path() / "a/to_the_end/schemes.csv"),
             all = advice::ranking(folder.path() / "t/schemes.csv");
  ASSERT_TRUE(first.cheapest() && last.cheapest());
  EXPECT_GT(error_in(all, *first.cheapest()), 2.0);
  EXPECT_LT(error_in(all, *last.cheapest()), 1.0);
  EXPECT_TRUE(is(last.choices.front(), all.choices.front()));
  for (const advice::Choice& one : last.choices)
    EXPECT_NEAR(one.error, error_in(all, one), 0.02 * one.error + 0.01) << one.reconstruction << one.steps;
}

}  // namespace
}  // namespace tandem::advise_command_tests
