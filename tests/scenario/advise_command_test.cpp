// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Advice beside what the study of a scene finds, where a part runs itself, models fail, or three may lead.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "command.hpp"
#include "json_of.hpp"
#include "long_run.hpp"
#include "tandem/advice/advice.hpp"
#include "tandem/advice/leading.hpp"

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

/// A mass at a spring that gets stiff beyond 1 m. Alone it stays within.
void write_stiffening(const Scratch& folder) {
  folder.write("stop.toml",
               "[inputs]\nf = { unit = 'N' }\n[outputs]\nx = { unit = 'm' }\n[blocks]\n"
               "spring = { kind = 'table', input = 'x', x = [-10, -1, 1, 10], y = [-2800, -100, 100, 2800], "
               "beyond = 'extend' }\n"
               "a = { kind = 'sum', inputs = ['f', 'spring', 'v'], gains = [1, -1, -0.2] }\n"
               "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v' }\n");
  folder.write("mass.toml",
               "[inputs]\nx1 = { unit = 'm' }\n[outputs]\nf = { unit = 'N' }\n[blocks]\n"
               "f = { kind = 'sum', inputs = ['x', 'x1'], gains = [20, -20] }\n"
               "a = { kind = 'sum', inputs = ['f', 'x'], gains = [-1, -30] }\n"
               "v = { kind = 'integrator', input = 'a', initial = 40 }\n"
               "x = { kind = 'integrator', input = 'v' }\n");
  folder.write(
      "s.toml",
      "[subsystems.stop]\nsource = 'diagram:stop.toml'\nparameters = { step = 2e-3, integrator = 'rk4' }\n"
      "[subsystems.mass]\nsource = 'diagram:mass.toml'\nparameters = { step = 1e-2, integrator = 'rk4' }\n"
      "[[connections]]\nfrom = 'stop.x'\nto = 'mass.x1'\nreconstruction = 'lagrange2'\n"
      "[[connections]]\nfrom = 'mass.f'\nto = 'stop.f'\nreconstruction = 'lagrange1'\n"
      "[coordination]\nschedule = 'slowest-first'\n[span]\nstop = 10\n"
      "[judge]\nquantity = 'stop.x'\ntolerance = 1e-2\n");
}

TEST(AdviseCommand, ModelsThatHoldAloneAndNotTogetherAreNotUsed) {
  const Scratch folder;
  write_stiffening(folder);
  const Said said = tandem(folder, {"advise", "s.toml", "--output", "a"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("stop (diagram:stop.toml): a linear model"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("so no model is used, and each scheme runs to 1.5 s"), std::string::npos)
      << said.out;
  ASSERT_EQ(tandem(folder, {"sweep", "s.toml", "--output", "t"}).status, 0);
  const auto last = advice::ranking(folder.path() / "a/to_the_end/schemes.csv"),
             all = advice::ranking(folder.path() / "t/schemes.csv");
  ASSERT_TRUE(last.cheapest());
  EXPECT_NEAR(last.cheapest()->error, error_in(all, *last.cheapest()), 0.05 * last.cheapest()->error);
  EXPECT_TRUE(is(*last.cheapest(), *all.cheapest()));
}

/// A ring, whose second follows its input at once.
void write_ring(const Scratch& folder) {
  const std::string begin =
                        "[parameters]\nw = { value = 10, unit = 'rad/s' }\ng = { value = 1, unit = '1' }\n"
                        "x0 = { value = 0, unit = 'm' }\n[inputs]\nu = { unit = 'm' }\n[outputs]\n"
                        "y = { unit = 'm' }\n[blocks]\n",
                    end =
                        "e = { kind = 'sum', inputs = ['u', 'x', 'v'], gains = ['$(g*w*w)', '$(-w*w)', "
                        "'$(-0.2*w)'] }\nv = { kind = 'integrator', input = 'e' }\n"
                        "x = { kind = 'integrator', input = 'v', initial = '$x0' }\n";
  folder.write("late.toml", begin + "y = { kind = 'gain', input = 'x', gain = 1 }\n" + end);
  folder.write("direct.toml", begin + "y = { kind = 'sum', inputs = ['x', 'u'], gains = [1, 0.3] }\n" + end);
  const auto part = [](const std::string& name, const std::string& file, const std::string& values) {
    return "[subsystems." + name + "]\nsource = 'diagram:" + file +
           ".toml'\nparameters = { integrator = " + "'rk4', " + values + " }\n";
  };
  folder.write("s.toml",
               part("a", "late", "step = 1e-2, w = 5, g = 0.4, x0 = 1") +
                   part("b", "direct", "step = 5e-3, w = 9, g = 0.5") +
                   part("c", "late", "step = 1e-3, w = 30, g = 0.6") +
                   "[[connections]]\nfrom = 'a.y'\nto = 'b.u'\n"
                   "[[connections]]\nfrom = 'b.y'\nto = 'c.u'\n"
                   "[[connections]]\nfrom = 'c.y'\nto = 'a.u'\n"
                   "[coordination]\nscheme = 'auto'\nschedule = 'slowest-first'\n"
                   "[span]\nstop = 5\n[record]\nclock = 'a'\n[judge]\nquantity = 'a.y'\ntolerance = 1e-3\n");
}

double exchanges_of(const std::filesystem::path& results) {
  double all = 0.0;
  const auto machine = test::json_of(results / "machine.json");
  for (const auto& one : machine.at("subsystems")) all += one.at("exchanges").get<double>();
  return all;
}

TEST(AdviseCommand, OfThreeTheOneLeadsWithWhomItIsCheaper) {
  const Scratch folder;
  write_ring(folder);
  const Said said = tandem(folder, {"run", "s.toml", "--output", "a"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("steps x 1, order b a c; its error is "), std::string::npos) << said.out;
  std::vector<std::string> words = {"run", "s.toml", "--set", "coordination.scheme=stated"};
  for (const char* to : {"b.u", "c.u", "a.u"})
    words.insert(words.end(), {"--set", "connections[" + std::string(to) + "].reconstruction=lagrange4"});
  words.insert(words.end(), {"--output", "usual"});
  ASSERT_EQ(tandem(folder, words).status, 0);
  words.back() = "fine";
  for (const char* step : {"a.parameters.step=1e-3", "b.parameters.step=1e-3", "c.parameters.step=1e-4"})
    words.insert(words.end(), {"--set", "subsystems." + std::string(step)});
  ASSERT_EQ(tandem(folder, words).status, 0);
  EXPECT_LT(exchanges_of(folder.path() / "a"), 0.81 * exchanges_of(folder.path() / "usual"));
  const Said compared = tandem(folder, {"compare", "a", "fine", "--columns", "a.y", "--tolerance", "1e-6"});
  EXPECT_EQ(compared.status, 0) << compared.out << compared.err;
}

/// Three of equal steps: who leads without a word is told by more than the file.
TEST(AdviseCommand, OrdersBeginWithThatOfTheRun) {
  const Scratch folder;
  write_ring(folder);
  const auto read = [&](const std::string& schedule, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"coordination.scheme=stated", "coordination.schedule=" + schedule,
                             "subsystems.a.parameters.step=1e-2", "subsystems.b.parameters.step=1e-2",
                             "subsystems.c.parameters.step=1e-2"});
    for (const char* to : {"b.u", "c.u", "a.u"})
      more.push_back("connections[" + std::string(to) + "].reconstruction=lagrange1");
    return scenario::read(folder.path() / "s.toml", more);
  };
  for (const std::string schedule : {"slowest-first", "fastest-first"}) {
    const auto usual = read(schedule);
    scenario::Assembly run(usual, test::sources());
    run.initialize();
    const auto all = advice::orders(run.coordinator());
    ASSERT_EQ(all.size(), 3U);
    std::set<std::string> leaders;
    for (const auto& order : all) {
      const auto stated = read(schedule, {advice::override_of(order)});
      scenario::Assembly other(stated, test::sources());
      other.initialize();
      const auto now = other.coordinator().schedule().order(), before = run.coordinator().schedule().order();
      leaders.insert(other.topology().name(now.front()));
      EXPECT_EQ(std::ranges::equal(now, before), order == all.front()) << schedule;
    }
    EXPECT_EQ(leaders.size(), 3U) << schedule;
  }
}

}  // namespace
}  // namespace tandem::advise_command_tests
