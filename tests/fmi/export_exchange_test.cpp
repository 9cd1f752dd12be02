// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams exported for Model Exchange.
#include <gtest/gtest.h>

#include <cmath>

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

TEST(ExportedExchange, BouncesOfABallAreWhereTheyAreInClosedForm) {
  const Exports exports;
  Builtins sources;
  add_fmi(sources, {}, {integrator_words(), take_integrator});
  for (const Version version : {Version::two, Version::three}) {
    const auto fmu = exports.fmu("ball", ball, version, Interface::model_exchange);
    for (const std::string integrator : {"rk4", "cvode_bdf", "erkstep"}) {
      std::string tight = integrator == "rk4" ? "" : "&relative_tolerance=1e-11&absolute_tolerance=1e-12";
      const FmuRun run(*open("fmu:" + fmu.string() + "?integrator=" + integrator + tight, sources), 2.3);
      EXPECT_LT(error_of_bounces(run.rows), 1e-9) << integrator;
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
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"other states or more events", "another export"},
                      [&] { exports.fmu("x", text, Version::two, Interface::model_exchange); }));
  exports.fmu("x", text);  // of Co-Simulation it may have either
}

/// A limit that is ignored has no event. Its indicator is there all the same.
TEST(ExportedExchange, AWordMayLeaveEventsOut) {
  const Exports exports;
  const auto engine = exports.of(TANDEM_SOURCE_DIR "/scenarios/engine/engine.toml", "engine", Version::two,
                                 Interface::model_exchange);
  const auto run = [&](const std::string& word) {
    return FmuRun(*Exports::open(engine, "step=1e-3&set.stall=" + word), 0.2, {8.97, 25.0}).rows;
  };
  EXPECT_EQ(run("ignore"), run("stop"));
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
