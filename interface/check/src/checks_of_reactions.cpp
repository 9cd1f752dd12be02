// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Of inputs that answer outputs (tandem/reaction.h).
#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "number_text.hpp"

namespace tandem::checks {
namespace {

constexpr double some_steps = 40.5;  // own steps

/// Two states, of which the first input has `gain` times the first.
struct TwoStates {
  static constexpr std::int32_t first_output = 2;  ///< as where a term is from
  std::vector<tandem_reaction_term> terms;
  std::vector<tandem_reaction_course> courses;
  double gain = 0.0;
  std::vector<double> begin = {0.5, -0.25};

  Reaction at(double origin) const {
    return {2,
            static_cast<std::int32_t>(terms.size()),
            static_cast<std::int32_t>(courses.size()),
            origin,
            terms.data(),
            courses.data(),
            begin.data()};
  }
};

bool may_react(const Instance& it) {
  const SubsystemInfo& info = it.subsystem->info();
  require(!it.can().reactive_inputs || (info.input_size() > 0 && info.output_size() > 0),
          "it says that its inputs may react, and has none, or no output; allowed is one of each");
  return it.can().reactive_inputs;
}

/// All calls that it takes, each from the states of the newest row. one_by_one: a call for each own step.
void go_to(Instance& it, double t_limit, TwoStates of, bool one_by_one) {
  const Reaction reaction = of.at(it.clock.time);
  const tandem_reactive_input input{&reaction, 0, of.gain};
  while (!it.tolerance().before(t_limit, it.clock.next_time) && it.clock.stop != Stop::finished) {
    it.react(&input, reaction.states);
    it.call_once(one_by_one ? it.clock.next_time : t_limit);
    std::copy(it.rows.back().end() - 2, it.rows.back().end(), of.begin.begin());
  }
}

void integrate_along(const Subject& of) {
  Instance it(of);
  if (!may_react(it)) return;
  const double begin = it.clock.time;
  go_to(it, it.ahead(some_steps), {{{1, 0, 1.0, 0.0}}, {{0, 0, {1.0, 0.0, 0.0, 0.0}}}}, false);
  for (std::size_t k = 1; k < it.rows.size(); ++k) {
    const std::vector<double>& row = it.rows[k];
    const double s = row[0] - begin, expected[] = {0.5 + s, -0.25 + s * (0.5 + s / 2.0)};
    for (int i = 0; i < 2; ++i) {
      const double found = row[row.size() - 2 + static_cast<std::size_t>(i)];
      require(std::abs(found - expected[i]) <= 1e-9 * (1.0 + std::abs(expected[i])),
              "the states z0' = 1, z1' = z0 are " + number_text(found) + " at t = " + number_text(row[0]) +
                  " s in place " + std::to_string(i) + "; allowed is " + number_text(expected[i]));
    }
  }
}

/// By the trapezoidal rule over the rows, which is off by no more than its difference from that over each second row.
void follow_the_outputs(const Subject& of) {
  Instance it(of);
  if (!may_react(it)) return;
  if (it.can().events) return;
  go_to(it, it.ahead(some_steps), {{{0, TwoStates::first_output, 1.0, 0.0}}, {}}, false);
  double fine = 0.5, coarse = 0.5;
  const auto y = [&](std::size_t k) { return it.rows[k][2]; };
  const auto area = [&](std::size_t a, std::size_t b) {
    return 0.5 * (it.rows[b][0] - it.rows[a][0]) * (y(a) + y(b));
  };
  for (std::size_t k = 2; k < it.rows.size(); k += 2) {
    fine += area(k - 2, k - 1) + area(k - 1, k), coarse += area(k - 2, k);
    const double found = it.rows[k][it.rows[k].size() - 2];
    require(std::abs(found - fine) <= std::abs(fine - coarse) + 1e-9 * (1.0 + std::abs(fine)),
            "the state z0' = its first output is " + number_text(found) + " at t = " +
                number_text(it.rows[k][0]) + " s; allowed is " + number_text(fine) + ", by the samples");
  }
}

/// An answer that is constant is as an input that is as much more, also where another input jumps within a call.
void add_to_the_input(const Subject& of) {
  Instance it(of), other(of);
  if (!may_react(it)) return;
  const auto& constant = of.settings.constant;
  if (std::find(constant.begin(), constant.end(), true) != constant.end())
    throw LeftOut("an input is to be constant");
  const double end = it.ahead(some_steps), jump = it.ahead(20.3);
  it.let_last_input_jump(jump), other.let_last_input_jump(jump);
  go_to(it, end, {{}, {}, 1.0}, false);
  other.raise_first_input(0.5);
  other.go_to(end);
  require(it.rows.size() == other.rows.size(), "an answer that is constant makes it take other steps");
  for (std::size_t row = 1; row < it.rows.size(); ++row)
    for (std::size_t k = 0; k < other.rows[row].size(); ++k) {
      const double found = it.rows[row][k], expected = other.rows[row][k];
      require(std::abs(found - expected) <= 1e-9 * (1.0 + std::abs(expected)),
              "with an answer of 0.5 its column " + std::to_string(k) + " is " + number_text(found) +
                  " at t = " + number_text(it.rows[row][0]) + " s; allowed is " + number_text(expected) +
                  ", as with an input that is 0.5 more");
    }
}

void keep_nothing(const Subject& of) {
  Instance one(of), many(of);
  if (!may_react(one)) return;
  const double end = one.ahead(some_steps);
  constexpr std::int32_t y = TwoStates::first_output;
  const TwoStates by{
      {{0, 0, -1.0, 0.0}, {1, 0, 1.0, 0.5}, {1, 1, -2.0, 0.0}, {0, y, 1.0, 0.0}, {1, y, 0.5, 0.1}},
      {{0, 0, {0.1, 0.0, 0.0, 0.2}}, {1, 0, {0.0, 0.3, 0.0, 0.0}}},
      0.01};
  go_to(one, end, by, false), go_to(many, end, by, true);
  require_same(many.rows, one.rows, "with inputs that react, step by step");
}

}  // namespace

const std::vector<Check> reactions = {{"states of a reaction are integrated along", integrate_along},
                                      {"a reaction follows the outputs", follow_the_outputs},
                                      {"an answer is a part of its input", add_to_the_input},
                                      {"nothing of a reaction is kept between calls", keep_nothing}};

}  // namespace tandem::checks
