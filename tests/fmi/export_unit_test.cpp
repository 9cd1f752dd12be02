// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "exports.hpp"
#include "random_diagram.hpp"
#include "refusal.hpp"
#include "tandem/exported/stepped_unit.hpp"

namespace tandem::test {
namespace {

using Unit = exported::SteppedUnit;

/// Steps that fit nothing, with inputs by chance.
void go(Unit& unit, std::mt19937& random, int steps) {
  std::uniform_real_distribution<double> any(-1.0, 1.0), length(0.001, 0.09);
  for (int k = 0; k < steps; ++k) {
    unit.set(1, any(random)), unit.set(2, any(random));
    if (k % 3 == 1) unit.set_derivative(2, 1 + k % 5, any(random));
    unit.step(unit.time(), length(random));
  }
}

std::vector<double> numbers(Unit& unit) {
  std::vector<double> all;
  for (std::size_t k = 0; k < unit.variables().size(); ++k)
    if (unit.variable(k).kind < exported::Variable::Kind::word) all.push_back(unit.number(k));
  return all;
}

/// Wherever it is saved, and whatever stands in the unit that takes it.
TEST(ExportedUnit, GoesOnFromItsStateWithTheSameBits) {
  std::mt19937 random(24);
  const Exports exports;
  for (int k = 0; k < 12; ++k) {
    const std::string name = "s" + std::to_string(k), text = RandomDiagram(random).text();
    SCOPED_TRACE(text);
    const auto file = exports.folder.write(name + ".toml", text);
    const auto resources = exports.unpacked(exports.of("diagram:" + file.string() + "?step=0.03", name));
    Unit one(resources), other(resources);
    one.set_span(k - 5.0);
    one.set(one.variables().size() - 3, 0.7);         // the parameter k
    one.set(one.variables().size() - 1, k % 2 == 0);  // extrapolate
    go(one, random, k);
    if (k % 3 == 0) go(other, random, 5);
    const auto state = one.state();
    other.restore(state);
    EXPECT_EQ(other.state(), state);
    std::mt19937 same = random;
    go(one, random, 20), go(other, same, 20);
    EXPECT_EQ(numbers(one), numbers(other));
    one.reset();
    EXPECT_EQ(numbers(one), numbers(*std::make_unique<Unit>(resources)));
  }
}

/// One of a mechanism, and one that samples.
TEST(ExportedUnit, OfAnyKindGoesOnFromItsState) {
  const Exports exports;
  const std::string sources[] = {"mechanism:" TANDEM_SOURCE_DIR
                                 "/scenarios/mechanisms/slider_crank/slider_crank.toml?animate=true",
                                 "diagram:" TANDEM_SOURCE_DIR "/scenarios/drive/controller.toml"};
  for (const std::string& source : sources) {
    const auto resources = exports.unpacked(exports.of(source, "one"));
    Unit one(resources), other(resources);
    for (int k = 0; k < 7; ++k) one.step(one.time(), 0.0037);
    other.restore(one.state());
    for (Unit* unit : {&one, &other})
      for (int k = 0; k < 9; ++k) unit->step(unit->time(), 0.0029);
    EXPECT_EQ(numbers(one), numbers(other)) << source;
    one.reset(), other.reset();
    Unit fresh(resources);
    for (Unit* unit : {&one, &fresh}) unit->step(0.0, 0.01);
    EXPECT_EQ(numbers(one), numbers(fresh)) << source;
    std::filesystem::remove_all(resources);
  }
}

TEST(ExportedUnit, TellsParametersThatFollowOthers) {
  const Exports exports;
  Unit unit(exports.unpacked(exports.fmu(
      "p",
      "[parameters]\nT = { value = 2, unit = 's' }\nk = { value = '$(3 * T)', unit = '1' }\n[blocks]\n"
      "x = { kind = 'lag', input = 1, time = '$T', gain = '$k' }\n[outputs]\nx = { unit = '1' }\n"
      "[run]\nstep = 0.1\nT = 5\n")));  // and of a table run without a stop
  EXPECT_EQ(unit.number(3), 5.0);
  EXPECT_EQ(unit.number(4), 15.0);
  unit.set(3, 4.0);
  EXPECT_EQ(unit.number(4), 12.0);
  unit.set(4, 1.0);
  EXPECT_EQ(unit.number(4), 1.0);
}

class OfOne : public testing::Test {
 protected:
  void refuses_call(ErrorCode code, const std::vector<std::string>& words,
                    const std::function<void()>& call) {
    EXPECT_TRUE(refuses(code, words, call));
  }
  Exports exports;
  Unit unit{exports.unpacked(exports.fmu(
      "x",
      "[parameters]\nT = { value = 0.1, unit = 's' }\nsign = { value = 'plus', allowed = ['plus', 'minus'] "
      "}\n"
      "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'lag', input = 'u', time = '$T' }\n[outputs]\n"
      "x = { unit = '1' }\n[run]\nstep = 0.01\n"))};
};

TEST_F(OfOne, RefusesWhatIsNotItsOwn) {
  const auto code = ErrorCode::invalid_argument;
  refuses_call(code, {"no variable of value reference 7", "0 to 6"}, [&] { unit.number(7); });
  refuses_call(code, {"'x' is no input"}, [&] { unit.set(2, 1.0); });
  refuses_call(code, {"'time' is no input"}, [&] { unit.set(0, 1.0); });
  refuses_call(code, {"'sign' is no number"}, [&] { unit.number(5); });
  refuses_call(code, {"'T' is no parameter that is a text"}, [&] { unit.set(4, std::string("a")); });
  refuses_call(code, {"'u' at t = 0 s is nan"}, [&] { unit.set(1, std::nan("")); });
  refuses_call(code, {"derivative 1 of 'u' at t = 0 s is inf"},
               [&] { unit.set_derivative(1, 1, std::numeric_limits<double>::infinity()); });
  refuses_call(code, {"order 6", "1 to 5"}, [&] { unit.set_derivative(1, 6, 1.0); });
  refuses_call(code, {"'x' has no time derivative of order 2"}, [&] { unit.derivative(2, 2); });
}

TEST(ExportedUnit, HasOutputsThatFollowInputsAtOnceByNewInputs) {
  const Exports exports;
  Unit unit(exports.unpacked(
      exports.fmu("f",
                  "[inputs]\nu = { unit = '1' }\nw = { unit = '1' }\n[blocks]\n"
                  "x = { kind = 'integrator', input = 'u' }\ny = { kind = 'sum', inputs = ['x', 'w'] }\n"
                  "z = { kind = 'relay', input = 'w', low = -1, high = 1 }\n[outputs]\n"
                  "x = { unit = '1' }\ny = { unit = '1' }\nz = { unit = '1' }\n[run]\nstep = 0.25\n")));
  const auto values = [&] { return std::vector<double>{unit.number(3), unit.number(5), unit.number(6)}; };
  using Values = std::vector<double>;
  unit.set(1, 1.0), unit.set(2, 0.5);
  EXPECT_EQ(values(), (Values{0.0, 0.5, 0.0}));
  unit.step(0.0, 0.5);
  EXPECT_EQ(values(), (Values{0.5, 1.0, 0.0}));
  unit.set(2, 2.0);
  const auto state = unit.state();
  EXPECT_EQ(values(), (Values{0.5, 2.5, 1.0}));
  unit.set(2, 0.0);  // the relay stays
  EXPECT_EQ(values(), (Values{0.5, 0.5, 1.0}));
  unit.restore(state);
  unit.set(2, 0.0);
  EXPECT_EQ(values(), (Values{0.5, 0.5, 0.0}));
  unit.step(0.5, 0.5);
  EXPECT_EQ(values(), (Values{1.0, 1.0, 0.0}));
}

/// 0.01 is no binary fraction: after 20 000 steps the sum is off by 4e-11 s, more than a billionth of a step.
TEST_F(OfOne, HasItsNodesWherePointsAreAddedUp) {
  constexpr int steps = 20000;
  unit.set(1, 1.0);
  std::vector<double> added;
  double t = 0.0;
  for (int k = 0; k < steps; ++k, t += 0.01) {
    unit.set(1, 1.0 * (k % 7));
    unit.step(t, 0.01);
    added.push_back(unit.number(2));
  }
  EXPECT_EQ(unit.number(0), t);
  unit.reset();
  for (int k = 0; k < steps; ++k) {
    unit.set(1, 1.0 * (k % 7));
    unit.step(unit.time(), (k + 1) * 0.01 - k * 0.01);
    ASSERT_EQ(unit.number(2), added[static_cast<std::size_t>(k)]) << k;
  }
}

TEST_F(OfOne, RefusesCallsOutOfPlace) {
  const auto code = ErrorCode::invalid_argument;
  refuses_call(code, {"start is at nan s"}, [&] { unit.set_span(std::nan("")); });
  refuses_call(code, {"start is at 2 s, the stop at 1 s"}, [&] { unit.set_span(2.0, 1.0); });
  refuses_call(code, {"from t = 1 s, but it stands at 0 s"}, [&] { unit.step(1.0, 1.0); });
  refuses_call(code, {"is 0 s long", "above 0"}, [&] { unit.step(0.0, 0.0); });
  unit.set_span(0.0, 0.15);
  unit.step(0.0, 0.1);
  refuses_call(code, {"0.1 s is 0.1 s long, past the stop at 0.15 s"}, [&] { unit.step(0.1, 0.1); });
  refuses_call(code, {"'extrapolate' is set"}, [&] { unit.set(6, true); });
  refuses_call(ErrorCode::wrong_state, {"after the start"}, [&] { unit.set_span(0.0); });
  refuses_call(code, {"parameter 'T' is set at t = 0.1 s", "before the start"}, [&] { unit.set(4, 1.0); });
}

TEST_F(OfOne, RefusesAStateThatIsNotItsOwn) {
  const auto code = ErrorCode::invalid_argument;
  auto state = unit.state();
  const auto cut = [&](std::size_t size) { unit.restore(std::span(state).first(size)); };
  for (std::size_t size = 0; size < state.size(); ++size)
    refuses_call(code, {"state of the FMU"}, [&] { cut(size); });
  unit.step(0.0, 0.1);
  state = unit.state();
  unit.step(0.1, 0.1);
  state.pop_back();
  refuses_call(code, {"state of"}, [&] { unit.restore(state); });
  EXPECT_EQ(unit.number(0), 0.2);
  state[8] ^= std::byte{1};  // in the token
  refuses_call(code, {"another FMU"}, [&] { unit.restore(state); });
}

}  // namespace
}  // namespace tandem::test
