// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "exports.hpp"
#include "random_diagram.hpp"
#include "refusal.hpp"

namespace tandem::test {
namespace {

using fmi::Version;

/// The last of rows that are at one time.
std::vector<std::vector<double>> last_of_each_time(std::vector<std::vector<double>> rows) {
  std::vector<std::vector<double>> all;
  for (auto& row : rows) {
    if (!all.empty() && all.back()[0] == row[0]) all.pop_back();
    row[1] = 0.0;  // a jump is known within a process alone
    all.push_back(std::move(row));
  }
  return all;
}

void keep_outputs(std::vector<std::vector<double>>& rows, int outputs) {
  for (auto& row : rows) row.resize(static_cast<std::size_t>(Samples::header + outputs));
}

/// Rows at the nodes of the own step, without those that events put between them.
std::vector<std::vector<double>> at_nodes(const std::vector<std::vector<double>>& rows, double step) {
  std::vector<std::vector<double>> all;
  for (const auto& row : rows)
    if (const double k = std::round(row[0] / step); row[0] == k * step) all.push_back(row);
  return all;
}

TEST(Export, FiftyRandomDiagramsGiveTheBitsOfTheirSources) {
  std::mt19937 random(20261127);
  const Exports exports;
  for (int k = 0; k < 50; ++k) {
    const std::string text = RandomDiagram(random).text(), name = "d" + std::to_string(k);
    SCOPED_TRACE(text);
    const auto fmu =
        exports.of("diagram:" + exports.folder.write(name + ".toml", text).string() + "?step=0.03125", name,
                   k % 2 == 0 ? Version::two : Version::three);
    const auto one = Exports::open(fmu, "inputs=left&step=0.03125");
    const auto other = open(
        "diagram:" + (exports.folder.path() / (name + ".toml")).string() + "?step=0.03125", file_sources());
    const std::vector<double> u = {0.8, -0.6};
    auto a = FmuRun(*one, 2.0, u).rows, b = at_nodes(last_of_each_time(FmuRun(*other, 2.0, u).rows), 0.03125);
    keep_outputs(a, one->info().output_size()), keep_outputs(b, one->info().output_size());
    EXPECT_EQ(a.size(), 65u);
    EXPECT_EQ(last_of_each_time(a), b);
    std::filesystem::remove(fmu);
  }
}

TEST(Export, OfAMechanismGivesTheBitsOfItsSource) {
  const Exports exports;
  const std::string file = TANDEM_SOURCE_DIR "/scenarios/mechanisms/slider_crank/slider_crank.toml";
  for (const Version version : {Version::two, Version::three}) {
    const auto one =
        Exports::open(exports.of("mechanism:" + file + "?animate=true", "x", version), "inputs=left");
    const auto other = open("mechanism:" + file + "?animate=true", file_sources());
    auto a = FmuRun(*one, 0.5).rows, b = FmuRun(*other, 0.5).rows;
    keep_outputs(a, one->info().output_size()), keep_outputs(b, one->info().output_size());
    EXPECT_GT(a.size(), 10u);
    EXPECT_EQ(a, b);
  }
}

TEST(Export, GivesTheSameBytesAgain) {
  const Exports first, second;
  const std::string text = RandomDiagram(*std::make_unique<std::mt19937>(7)).text() + "[run]\nstep = 0.01\n";
  EXPECT_EQ(read_text(first.fmu("same", text)), read_text(second.fmu("same", text)));
}

/// T v' = k F - v.
const std::string lagging_mass =
    "name = 'mass'\ndescription = 'A <mass> & \"more\"'\n[parameters]\nT = { value = 2, unit = 's' }\n"
    "k = { value = '$(3 * T)', unit = 'm/(N s)' }\n[inputs]\nF = { unit = 'N' }\n[blocks]\n"
    "v = { kind = 'lag', input = 'F', time = '$T', gain = '$k' }\n[outputs]\nv = { unit = 'm/s' }\n"
    "F = { unit = 'N', from = 'F' }\n[run]\nstart = 1\nstop = 3\nstep = 0.125\n[run.inputs]\nF = 4\n";

TEST(Export, DescribesWhatItHas) {
  const Exports exports;
  for (const Version version : {Version::two, Version::three}) {
    const fmi::Archive archive(exports.fmu("of a mass", lagging_mass, version));
    const auto d = fmi::read_description(archive.text("modelDescription.xml", 1 << 20), "x");
    EXPECT_EQ(d.version, version);
    EXPECT_EQ(d.name, "mass");
    EXPECT_EQ(d.text, "A <mass> & \"more\"");
    ASSERT_TRUE(d.co_simulation);
    EXPECT_EQ(d.co_simulation->model, "of_a_mass");
    EXPECT_TRUE(d.co_simulation->keeps_state && d.co_simulation->serializes_state);
    EXPECT_EQ(d.co_simulation->interpolates_inputs, version == Version::two);
    EXPECT_EQ(d.experiment.step, 0.125);
    std::string all;
    for (const fmi::Variable& v : d.variables)
      all += v.name + " " + v.unit + " " + v.start.value_or("-") + "; ";
    EXPECT_EQ(all,
              "time s -; F N 4; v m/s -; der(v)  -; output.F N -; T s 2; k m/(N s) 6; extrapolate  false; ");
    ASSERT_EQ(d.outputs.size(), 2u);
    EXPECT_TRUE(d.outputs[0].of.empty() && !d.outputs[0].of_all);
    EXPECT_EQ(d.outputs[1].of, std::vector<int>{1});
    EXPECT_TRUE(archive.has("documentation/index.html") && archive.has("documentation/licenses/license.txt"));
  }
}

double v_at_the_end(const std::filesystem::path& fmu, const std::string& parameters) {
  return FmuRun(*Exports::open(fmu, "inputs=left" + parameters), 2.0, {4.0}).rows.back()[2];
}

/// After two seconds, from rest: k F (1 - exp(-2 / T)).
TEST(Export, TakesParametersOnWhichOthersDepend) {
  const Exports exports;
  for (const Version version : {Version::two, Version::three}) {
    const auto fmu = exports.fmu("mass", lagging_mass, version);
    const double rk4 = 1e-5;  // of steps of T / 8
    EXPECT_NEAR(v_at_the_end(fmu, ""), 24.0 * (1.0 - std::exp(-1.0)), 24.0 * rk4);
    EXPECT_NEAR(v_at_the_end(fmu, "&set.T=1"), 12.0 * (1.0 - std::exp(-2.0)), 12.0 * rk4);
    EXPECT_NEAR(v_at_the_end(fmu, "&set.T=1&set.k=2"), 8.0 * (1.0 - std::exp(-2.0)), 8.0 * rk4);
    EXPECT_TRUE(
        refuses(ErrorCode::numerical, {"time", "-1", "above 0"}, [&] { v_at_the_end(fmu, "&set.T=-1"); }));
  }
}

/// A sampled source acts at its instants up to and with the end of a step, as it does in a run of tandem.
TEST(Export, OfASampledSourceGivesWhatASampledSubsystemGives) {
  const Exports exports;
  const auto fmu = exports.fmu(
      "steps",
      "[inputs]\nu = { unit = '1' }\n[blocks]\nnext = { kind = 'sum', inputs = ['sum', 'u'] }\n"
      "sum = { kind = 'sample', input = 'next', period = 0.5 }\n[outputs]\nsum = { unit = '1' }\n");
  const auto rows = FmuRun(*Exports::open(fmu, "inputs=left&step=0.25"), 1.5, {2.0}).rows;
  std::vector<double> sums;
  for (const auto& row : rows) sums.push_back(row[2]);
  EXPECT_EQ(sums, (std::vector<double>{2, 2, 4, 4, 6, 6, 8}));  // its first instant is the start
}

void refuses_export(const std::string& text, const std::vector<std::string>& words) {
  const Exports exports;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, words, [&] { exports.fmu("x", text); })) << text;
  EXPECT_FALSE(std::filesystem::exists(exports.folder.path() / "x.fmu"));
}

TEST(Export, RefusesWhatCanNotGoAlong) {
  refuses_export("[blocks]\na = { kind = 'constant', value = 1 }\n[run]\nstep = 1\n", {"has no output"});
  refuses_export("[subsystems.x]\nsource = 'lib:x.so'\n[span]\nstop = 1\n",
                 {"x.toml:2", "'x' is lib:x.so", "scenario:FILE"});
  const std::string mechanism =
      "mechanism:" TANDEM_SOURCE_DIR "/scenarios/mechanisms/slider_crank/slider_crank.toml";
  for (const std::string& source :
       {"'" + mechanism + "'\nparameters.matrices = 'here'", "'" + mechanism + "?matrices=here'"}) {
    const Exports exports;
    exports.folder.write("inner.toml", "[subsystems.m]\nsource = " + source + "\n[span]\nstop = 1\n");
    const auto outer =
        exports.folder.write("x.toml", "[subsystems.x]\nsource = 'scenario:inner.toml'\n[span]\nstop = 1\n");
    EXPECT_TRUE(refuses(ErrorCode::not_supported, {"x.toml:2", "inner.toml:", "matrices", "writes no files"},
                        [&] { exports.of(outer.string()); }));
  }
  const Scratch elsewhere;
  elsewhere.write("t.csv", "time,a\n0,1\n1,2\n");
  refuses_export("[blocks]\na = { kind = 'csv', column = 'a', file = '" +
                     (elsewhere.path() / "t.csv").string() +
                     "' }\n[outputs]\na = { unit = '1' }\n[run]\nstep = 0.1\n",
                 {"t.csv", "named from the root"});
  const Exports exports;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"lib:x.so", "does not go along", "diagram:FILE"},
                      [&] { exports.of("lib:x.so"); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"nothing.toml", "not there"},
                      [&] { exports.of("diagram:nothing.toml"); }));
}

TEST(Export, TakesParametersOfTheUriAsThoseOfTheFile) {
  const Exports exports;
  const auto file = exports.folder.write("mass.toml", lagging_mass);
  const auto fmu = exports.of("diagram:" + file.string() + "?T=1&step=0.125");
  EXPECT_NEAR(v_at_the_end(fmu, ""), 12.0 * (1.0 - std::exp(-2.0)), 1e-4);
  EXPECT_NEAR(v_at_the_end(fmu, "&set.T=2"), 24.0 * (1.0 - std::exp(-1.0)), 1e-4);
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"matrices", "writes no files"}, [&] {
    exports.of("mechanism:" TANDEM_SOURCE_DIR
               "/scenarios/mechanisms/slider_crank/slider_crank.toml?matrices=x");
  }));
}

TEST(Export, RefusesWordsThatMakeItAnotherFmu) {
  const Exports exports;
  exports.folder.write(
      "a.toml", "[blocks]\nx = { kind = 'lag', input = 1, time = 1 }\n[outputs]\nx = { unit = '1' }\n");
  exports.folder.write(
      "b.toml", "[blocks]\nx = { kind = 'gain', input = 2 , gain = 1 }\n[outputs]\nx = { unit = '1' }\n");
  const std::string text =
      "[parameters]\nfile = { value = 'a.toml', allowed = ['a.toml', 'b.toml'] }\n[blocks]\n"
      "m = { kind = 'diagram', file = '$file' }\n[outputs]\nx = { unit = '1', from = 'm.x' }\n[run]\nstep = "
      "0.1\n";
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"other ports", "derivatives"}, [&] { exports.fmu("x", text); }));
  const Scratch elsewhere;
  const std::string far = elsewhere.write("c.toml", read_text(exports.folder.path() / "a.toml")).string();
  std::string other = text;
  other.replace(other.find("'b.toml'"), 8, "'" + far + "'");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"c.toml", "named from the root"},
                      [&] { exports.fmu("x", other); }));
}

/// The command has it; an FMU has not.
TEST(Export, RefusesASolverOfALibrary) {
  const Exports exports;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"klu", "eigen_dense, prepared, band"}, [&] {
    exports.of("mechanism:" TANDEM_SOURCE_DIR
               "/scenarios/mechanisms/slider_crank/slider_crank.toml?animate=true&solver=klu");
  }));
  EXPECT_FALSE(std::filesystem::exists(exports.folder.path() / "x.fmu"));
}

/// ".." behind a link is what the system takes it for.
TEST(Export, TakesAlongWhatIsNamedByWayOfALink) {
  const Exports exports;
  const auto folder = exports.folder.path();
  std::filesystem::create_directories(folder / "there/models");
  exports.folder.write("there/one.csv", "time,a\n0,3\n9,3\n");
  exports.folder.write("there/models/m.toml",
                       "[blocks]\na = { kind = 'csv', column = 'a', file = '../one.csv' }\n[outputs]\n"
                       "a = { unit = '1' }\n[run]\nstep = 0.5\n");
  std::filesystem::create_directory_symlink(folder / "there/models", folder / "link");
  const auto fmu = exports.of((folder / "link/m.toml").string());
  EXPECT_EQ(FmuRun(*Exports::open(fmu, "step=0.5"), 1.0).rows.back()[2], 3.0);
}

/// Files that any word of a list names go along, and lie to each other as they did.
TEST(Export, TakesAlongWhatFilesName) {
  const Exports exports;
  std::filesystem::create_directories(exports.folder.path() / "data");
  std::filesystem::create_directories(exports.folder.path() / "models");
  exports.folder.write("data/one.csv", "time,a\n0,1\n9,1\n");
  exports.folder.write("data/two.csv", "time,a\n0,2\n9,2\n");
  const auto file = exports.folder.write(
      "models/m.toml",
      "[parameters]\nrecord = { value = '../data/one.csv', allowed = ['../data/one.csv', '../data/two.csv'] "
      "}\n"
      "[blocks]\na = { kind = 'csv', column = 'a', file = '$record' }\n[outputs]\na = { unit = '1' }\n"
      "[run]\nstep = 0.5\n");
  const auto fmu = exports.of(file.string());
  std::filesystem::remove_all(exports.folder.path() / "data");
  EXPECT_EQ(FmuRun(*Exports::open(fmu, "step=0.5"), 1.0).rows.back()[2], 1.0);
  EXPECT_EQ(FmuRun(*Exports::open(fmu, "step=0.5&set.record=../data/two.csv"), 1.0).rows.back()[2], 2.0);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"three.csv", "allowed"},
                      [&] { FmuRun(*Exports::open(fmu, "step=0.5&set.record=three.csv"), 1.0); }));
}

}  // namespace
}  // namespace tandem::test
