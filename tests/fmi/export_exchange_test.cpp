// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams exported for Model Exchange.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exports.hpp"
#include "random_diagram.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "tandem/exported/exchanged_unit.hpp"
#include "tandem/sources/integrators.hpp"

namespace tandem::test {
namespace {

using exported::Interface;
using fmi::Version;

constexpr double h = 0.03125;

/// The row that holds from each time on.
std::vector<std::vector<double>> last_of_each(const std::vector<std::vector<double>>& rows) {
  std::vector<std::vector<double>> all;
  for (const auto& row : rows) {
    if (!all.empty() && all.back()[0] == row[0]) all.pop_back();
    all.push_back(row);
  }
  return all;
}

/// By the same method with the same steps; events of both are located to 1e-12 of one.
void expect_the_same_run(Subsystem& one, Subsystem& other) {
  const std::vector<double> u = {0.8, -0.6};
  const auto a = last_of_each(FmuRun(one, 2.0, u).rows), b = last_of_each(FmuRun(other, 2.0, u).rows);
  const auto outputs = static_cast<std::size_t>(Samples::header + one.info().output_size());
  std::size_t k = 0;
  for (const auto& row : b) {
    while (k < a.size() && a[k][0] < row[0] - 1e-9) ++k;
    if (std::round(row[0] / h) * h != row[0]) continue;  // between nodes rows stand where outputs jump
    ASSERT_LT(k, a.size());
    ASSERT_NEAR(a[k][0], row[0], 1e-9);
    for (std::size_t c = 2; c < outputs; ++c)
      EXPECT_NEAR(a[k][c], row[c], 1e-9) << "column " << c << " at " << row[0];
  }
}

TEST(ExportedExchange, RandomDiagramsRunAsTheirSources) {
  std::mt19937 random(20261128);
  const Exports exports;
  int made = 0;
  for (int k = 0; k < 60; ++k) {
    const std::string text = RandomDiagram(random).text(), name = "d" + std::to_string(k);
    SCOPED_TRACE(text);
    const std::string source =
        "diagram:" + exports.folder.write(name + ".toml", text).string() + "?step=0.03125";
    if (text.find("'delay'") != std::string::npos) continue;
    const auto fmu =
        exports.of(source, name, k % 2 == 0 ? Version::two : Version::three, Interface::model_exchange);
    expect_the_same_run(*Exports::open(fmu, "step=0.03125"), *open(source, file_sources()));
    std::filesystem::remove(fmu);
    ++made;
  }
  EXPECT_GT(made, 20);
}

const std::string ball =
    "[blocks]\nv = { kind = 'integrator', input = -9.81, reset = 'below', reset_to = 'up' }\n"
    "up = { kind = 'gain', input = 'v', gain = -0.7 }\nx = { kind = 'integrator', input = 'v', initial = 1 "
    "}\n"
    "below = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = 'm' }\nv = { unit = 'm/s' }\n"
    "[run]\nstep = 0.01\n";

TEST(ExportedExchange, BouncesOfABallAreWhereTheyAreInClosedForm) {
  const Exports exports;
  Builtins sources;
  add_fmi(sources, {}, {integrator_words(), take_integrator});
  for (const Version version : {Version::two, Version::three}) {
    const auto fmu = exports.fmu("ball", ball, version, Interface::model_exchange);
    for (const std::string integrator : {"rk4", "cvode_bdf", "erkstep"}) {
      std::string tight = integrator == "rk4" ? "" : "&relative_tolerance=1e-11&absolute_tolerance=1e-12";
      std::vector<double> bounces;
      for (const auto& row :
           FmuRun(*open("fmu:" + fmu.string() + "?integrator=" + integrator + tight, sources), 2.3).rows)
        if (row[1] == 1.0) bounces.push_back(row[0]);
      double t = std::sqrt(2.0 / 9.81), flight = 2.0 * t;
      ASSERT_GE(bounces.size(), 6U) << integrator;
      for (const double bounce : bounces) {
        EXPECT_NEAR(bounce, t, 1e-9) << integrator;
        t += flight *= 0.7;
      }
    }
  }
}

/// A sampled diagram has time events alone.
TEST(ExportedExchange, OfASampledDiagramActsAtItsInstants) {
  const Exports exports;
  const auto fmu = exports.fmu(
      "steps",
      "[inputs]\nu = { unit = '1' }\n[blocks]\nnext = { kind = 'sum', inputs = ['sum', 'u'] }\n"
      "sum = { kind = 'sample', input = 'next', period = 0.5 }\n[outputs]\nsum = { unit = '1' }\n",
      Version::three, Interface::model_exchange);
  std::vector<double> sums;
  for (const auto& row : last_of_each(FmuRun(*Exports::open(fmu, "step=0.25"), 1.5, {2.0}).rows))
    sums.push_back(row[2]);
  EXPECT_EQ(sums, (std::vector<double>{2, 2, 4, 4, 6, 6, 8}));  // its first instant is the start
}

TEST(ExportedExchange, RefusesSignalsThatAreNotFiniteOrOutside) {
  const Exports exports;
  const auto refused = [&](const std::string& block, const std::vector<std::string>& words) {
    const auto fmu = exports.fmu("x",
                                 "[blocks]\nx = { kind = 'integrator', input = 1 }\n" + block +
                                     "\n[outputs]\ny = { unit = '1' }\n[run]\nstep = 0.1\n",
                                 Version::two, Interface::model_exchange);
    EXPECT_TRUE(refuses(ErrorCode::numerical, words, [&] { FmuRun(*Exports::open(fmu, "step=0.1"), 3.0); }));
    std::filesystem::remove(fmu);
  };
  refused("y = { kind = 'table', input = 'x', x = [0, 1, 2], y = [0, 1, 4], beyond = 'refuse' }",
          {"block 'y'", "0 to 2"});
}

TEST(ExportedExchange, RefusesWordsThatMakeItAnotherFmu) {
  const Exports exports;
  exports.folder.write(
      "a.toml", "[blocks]\nx = { kind = 'lag', input = 1, time = 1 }\n[outputs]\nx = { unit = '1' }\n");
  exports.folder.write(
      "b.toml",
      "[blocks]\nx = { kind = 'lag', input = 'v', time = 1 }\nv = { kind = 'lag', input = 1, time = 2 }\n"
      "[outputs]\nx = { unit = '1' }\n");
  const std::string text =
      "[parameters]\nfile = { value = 'a.toml', allowed = ['a.toml', 'b.toml'] }\n[blocks]\n"
      "m = { kind = 'diagram', file = '$file' }\n[outputs]\nx = { unit = '1', from = 'm.x' }\n[run]\nstep = "
      "0.1\n";
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"other states or events", "another export"},
                      [&] { exports.fmu("x", text, Version::two, Interface::model_exchange); }));
  exports.fmu("x", text);  // of Co-Simulation it may have either
}

TEST(ExportedExchange, DoesWhatIsDueWhereItIsTold) {
  const Exports exports;
  exported::ExchangedUnit unit(
      exports.unpacked(exports.fmu("ball", ball, Version::two, Interface::model_exchange)));
  EXPECT_TRUE(refuses(ErrorCode::wrong_state, {"start"}, [&] { unit.set_time(0.1); }));
  unit.begin();
  EXPECT_EQ(unit.event(), std::numeric_limits<double>::infinity());
  const double falling[] = {-3.0, -1e-12}, rising[] = {2.0, 1.0};
  unit.set_time(0.4), unit.set_states(falling);
  const double next = unit.event();
  EXPECT_NEAR(next, 0.4 + 1e-8, 1e-12);
  double x[2];
  unit.get_states(x);
  EXPECT_EQ(x[0], 0.7 * 3.0);
  unit.set_time(next), unit.set_states(rising);
  EXPECT_EQ(unit.event(), std::numeric_limits<double>::infinity());
  unit.get_states(x);
  EXPECT_EQ(x[0], 2.0);
}

/// y = x - y^2 has two solutions; the one near that of the last step counts, whatever was tried since.
TEST(ExportedExchange, WhatATryGivesDependsOnNoTryBefore) {
  const Exports exports;
  exported::ExchangedUnit unit(exports.unpacked(
      exports.fmu("loop",
                  "[blocks]\ny2 = { kind = 'function', function = 'square', input = 'y' }\n"
                  "y = { kind = 'sum', inputs = ['x', 'y2'], gains = [1, -1] }\n"
                  "dx = { kind = 'sum', inputs = ['x', 'y'], gains = [-50, -0.1] }\n"
                  "x = { kind = 'integrator', input = 'dx', initial = 5 }\n[loops]\nsolve = true\n[outputs]\n"
                  "x = { unit = '1' }\ny = { unit = '1' }\n[run]\nstep = 0.1\n",
                  Version::two, Interface::model_exchange)));
  unit.begin(), unit.event();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(-0.24, 20.0);
  double rate = 0.0;
  const auto rate_at = [&](double x) {
    unit.set_states({&x, 1});
    unit.get_rates({&rate, 1});
    return rate;
  };
  for (double x = 5.0; x > -0.2; x -= 0.05) rate_at(x), unit.step_done();
  const double right = rate_at(-0.2);
  EXPECT_NEAR(right, 10.0 - 0.1 * (std::sqrt(0.2) - 1.0) / 2.0, 1e-6);
  const auto state = unit.state();
  for (int k = 0; k < 50; ++k) {
    try {
      rate_at(any(random));
    } catch (const Error& error) {  // no solution from there
      EXPECT_EQ(error.code(), ErrorCode::numerical);
    }
    EXPECT_EQ(rate_at(-0.2), right);
  }
  unit.restore(state);
  EXPECT_EQ(rate_at(-0.2), right);
  rate_at(1.317);
  const double x = -0.2;
  unit.set_states({&x, 1});
  unit.event();
  unit.get_rates({&rate, 1});
  EXPECT_NEAR(rate, right, 1e-6);
}

/// The states after a reset are those of another start.
TEST(ExportedExchange, BeginsAnewAfterAReset) {
  const Exports exports;
  exported::ExchangedUnit unit(
      exports.unpacked(exports.fmu("ball", ball, Version::two, Interface::model_exchange)));
  double before[2], after[2], z[1];
  unit.get_states(before);  // as in initialization
  unit.begin();
  const double other[] = {5.0, 7.0};
  unit.set_time(1.0), unit.set_states(other);
  unit.reset();
  unit.get_states(after), unit.get_indicators(z);
  EXPECT_TRUE(std::equal(before, before + 2, after));
  EXPECT_EQ(z[0], -1.0);
}

TEST(ExportedExchange, DescribesItsStatesAndEvents) {
  const Exports exports;
  for (const Version version : {Version::two, Version::three}) {
    const std::string all = fmi::Archive(exports.fmu("ball", ball, version, Interface::model_exchange))
                                .text("modelDescription.xml", 1 << 20);
    const bool two = version == Version::two;
    const auto has = [&](const std::string& of_2, const std::string& of_3) {
      EXPECT_NE(all.find(two ? of_2 : of_3), std::string::npos) << (two ? of_2 : of_3) << all;
    };
    has("numberOfEventIndicators=\"1\"", "<EventIndicator valueReference=\"5\" />");
    has("<ModelExchange modelIdentifier=\"ball\"", "needsCompletedIntegratorStep=\"true\"");
    has("name=\"v\" valueReference=\"3\" causality=\"output\" variability=\"continuous\">\n      <Real "
        "unit=\"m/s\" reinit=\"true\" />",
        "<Float64 name=\"v\" valueReference=\"3\" causality=\"output\" variability=\"continuous\" "
        "unit=\"m/s\" reinit=\"true\" />");
    has("<Real derivative=\"4\" />", "derivative=\"3\"");
    // states by their order: v, x
    has("<Derivatives>\n      <Unknown index=\"5\" />\n      <Unknown index=\"3\" />",
        "<ContinuousStateDerivative valueReference=\"4\" />\n    <ContinuousStateDerivative "
        "valueReference=\"2\" />");
    has("<Unknown index=\"2\" dependencies=\"4 2 1\" />",
        "<Output valueReference=\"1\" dependencies=\"3 1 0\" />");
    has("<InitialUnknowns>\n      <Unknown index=\"2\" />", "<InitialUnknown valueReference=\"4\" />");
  }
}

TEST(ExportedExchange, BouncesThatHaveNoEndAreTold) {
  const Exports exports;
  const auto fmu = exports.fmu("ball", ball, Version::two, Interface::model_exchange);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"'v'", "ever faster"},
                      [&] { FmuRun(*Exports::open(fmu, "step=0.01"), 10.0); }));
}

/// x'' = (u - x) - x, from x = 1 at rest, with itself as the other side: both are cos t.
TEST(ExportedExchange, CoupledIsOfTheOrderOfTheSchemeAndGivesSlopes) {
  const Exports exports;
  const auto fmu = exports.fmu(
      "mass",
      "[inputs]\nu = { unit = '1' }\n[blocks]\na = { kind = 'sum', inputs = ['u', 'x'], gains = [1, -2] }\n"
      "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v', initial = 1 }\n"
      "[outputs]\nx = { unit = '1' }\n[run]\nstep = 0.01\n",
      Version::three, Interface::model_exchange);
  const auto error = [&](double step, const std::string& how) {
    const std::string with = "step=" + std::to_string(step);
    const auto one = Exports::open(fmu, with), other = Exports::open(fmu, with);
    RunBench bench;
    bench.add("one", *one).add("other", *other);
    bench.connect("one.x", "other.u", how).connect("other.x", "one.u", how);
    return std::abs(bench.run(2.0).rows(0).back()[2] - std::cos(2.0));
  };
  for (const char* how : {"lagrange3", "hermite"}) {
    const double coarse = error(0.04, how), fine = error(0.01, how);
    EXPECT_NEAR(std::log2(coarse / fine) / 2.0, 4.0, 0.2) << how << " " << coarse << " " << fine;
  }
}

/// An importer of its own: Euler's method with events, by chance.
class Importer {
 public:
  explicit Importer(exported::ExchangedUnit& unit) : unit_(unit), x_(unit.states_size()), dx_(x_) {}

  void begin() {
    unit_.begin();
    next_ = unit_.event();
  }
  void step(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1.0, 1.0), length(0.001, 0.03);
    const double begin = unit_.time(), end = std::min(begin + length(random), next_);
    unit_.set(1, any(random)), unit_.set(2, any(random));
    unit_.get_states(x_), unit_.get_rates(dx_);
    std::vector<double> z(unit_.indicators_size()), now(z);
    unit_.get_indicators(z);
    for (std::size_t k = 0; k < x_.size(); ++k) x_[k] += (end - begin) * dx_[k];
    unit_.set_time(end), unit_.set_states(x_);
    unit_.step_done();
    unit_.get_indicators(now);
    const bool crossed =
        !std::equal(z.begin(), z.end(), now.begin(), [](double a, double b) { return a * b > 0.0; });
    if (crossed || end >= next_) next_ = unit_.event();
  }
  std::vector<double> numbers() {
    std::vector<double> all;
    for (std::size_t k = 0; k < unit_.variables().size(); ++k)
      if (unit_.variable(k).kind < exported::Variable::Kind::word) all.push_back(unit_.number(k));
    return all;
  }
  double next() const { return next_; }
  void go_on(double next) { next_ = next; }

 private:
  exported::ExchangedUnit& unit_;
  std::vector<double> x_, dx_;
  double next_ = 0.0;
};

TEST(ExportedExchange, GoesOnFromItsStateWithTheSameBitsHereAndInAnotherInstance) {
  std::mt19937 random(29);
  const Exports exports;
  int made = 0;
  for (int k = 0; k < 25; ++k) {
    const std::string name = "s" + std::to_string(k), text = RandomDiagram(random).text();
    SCOPED_TRACE(text);
    if (text.find("'delay'") != std::string::npos) continue;
    const auto file = exports.folder.write(name + ".toml", text);
    const auto resources = exports.unpacked(
        exports.of("diagram:" + file.string() + "?step=0.03", name, Version::two, Interface::model_exchange));
    exported::ExchangedUnit one(resources), other(resources);
    one.set_span(k - 5.0);
    one.set(one.variables().size() - 2, 0.7);  // the parameter k
    Importer of_one(one), of_other(other);
    of_one.begin();
    for (int steps = 0; steps < 3 * k; ++steps) of_one.step(random);
    const auto state = one.state();
    other.restore(state);
    EXPECT_EQ(other.state(), state);
    of_other.go_on(of_one.next());
    std::mt19937 same = random;
    for (int steps = 0; steps < 50; ++steps) of_one.step(random), of_other.step(same);
    EXPECT_EQ(of_one.numbers(), of_other.numbers());
    one.reset();
    exported::ExchangedUnit fresh(resources);
    EXPECT_EQ(of_one.numbers(), Importer(fresh).numbers());
    ++made;
  }
  EXPECT_GT(made, 8);
}

TEST(ExportedExchange, RefusesWhatItIsNotFor) {
  const Exports exports;
  const auto refused = [&](const std::string& blocks, const std::vector<std::string>& words) {
    const std::string text =
        "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'lag', input = 'u', time = 1 }\n" + blocks +
        "\n[outputs]\ny = { unit = '1' }\n[run]\nstep = 0.1\n";
    EXPECT_TRUE(refuses(ErrorCode::not_supported, words,
                        [&] { exports.fmu("x", text, Version::two, Interface::model_exchange); }));
    EXPECT_FALSE(std::filesystem::exists(exports.folder.path() / "x.fmu"));
  };
  refused("y = { kind = 'delay', input = 'x', delay = 0.3 }", {"block 'y'", "past", "Co-Simulation"});
  refused("y = { kind = 'memory', input = 'x' }", {"block 'y'", "own steps", "Co-Simulation"});
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"is no diagram", "Co-Simulation"}, [&] {
    exports.of("mechanism:" TANDEM_SOURCE_DIR
               "/scenarios/mechanisms/slider_crank/slider_crank.toml?animate=true",
               "x", Version::two, Interface::model_exchange);
  }));
  const auto fmu = exports.fmu("ball", ball, Version::two, Interface::model_exchange);
  exported::ExchangedUnit unit(exports.unpacked(fmu));
  const double x[] = {1.0, 2.0, 3.0};
  unit.begin();
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"3 states", "2"}, [&] { unit.set_states(x); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"time is nan"}, [&] { unit.set_time(NAN); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"Co-Simulation"},
                      [&] { Exports::open(fmu, "type=cs&step=0.1"); }));
}

}  // namespace
}  // namespace tandem::test
