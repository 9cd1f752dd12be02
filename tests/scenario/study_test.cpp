// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A user's own study from the command line (scenarios/motor_crank).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "background.hpp"
#include "command.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::study_tests {
namespace {

using test::Background;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string scene = TANDEM_SOURCE_DIR "/scenarios/motor_crank/scene.toml";

/// The study of that folder with other axes, and more.
std::string study(const std::string& axes, const std::string& more = "") {
  return "scenario = '" + scene + "'\ncolumns = ['voltage', 'schedule', 'how', 'step']\n[set]\n" +
         R"toml("subsystems.motor.parameters.V" = "$voltage"
"subsystems.linkage.parameters.step" = "$step"
"subsystems.motor.parameters.step" = "$(step/2)"
"coordination.schedule" = "$schedule"
"connections.reconstruction" = "$how"
[[tables.schemes.blocks]]
axes = [)toml" +
         axes + R"toml(]
[references.fine]
per = ["voltage"]
with = { step = 1.25e-4, schedule = "fastest-first", how = "lagrange3" }
floor = true
[metrics]
speed_error = { of = "linkage.speed", norm = "max", relative = "peak" }
exchanges = {}
)toml" + more;
}

const std::string axes =
    "{ voltage = [50, 100] }, { schedule = ['slowest-first', 'parallel'] }, { how = ['lagrange0', "
    "'lagrange2'] }, "
    "{ step = [2e-3, 3e-3] }";

/// The speed at own steps, by `tandem run`.
text::TimeTable speed(const Scratch& folder, double voltage, const std::string& schedule,
                      const std::string& how, double step) {
  const Said said = tandem(
      folder, {"run", scene, "--output", "r", "--set", "record.clock=own", "--set", "record.derivatives=true",
               "--set", fmt::format("subsystems.motor.parameters.V={}", voltage), "--set",
               "coordination.schedule=" + schedule, "--set", "connections.reconstruction=" + how, "--set",
               fmt::format("subsystems.linkage.parameters.step={}", step), "--set",
               fmt::format("subsystems.motor.parameters.step={}", step / 2)});
  EXPECT_EQ(said.status, 0) << said.err;
  return text::TimeTable::read(folder.path() / "r/results.linkage.csv");
}

std::size_t column(const text::TimeTable& table, const std::string& name) {
  return static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) -
                                  table.names.begin());
}

/// The cubic Hermite polynomial of a fine table, by a formula of its own.
double at(const text::TimeTable& fine, double t) {
  const auto& y = fine.columns[column(fine, "linkage.speed")];
  const auto& d = fine.columns[column(fine, "der(linkage.speed)")];
  std::size_t k = 1;
  while (k + 1 < fine.times.size() && fine.times[k] < t) ++k;
  const double h = fine.times[k] - fine.times[k - 1], s = (t - fine.times[k - 1]) / h;
  return (1 + 2 * s) * (1 - s) * (1 - s) * y[k - 1] + s * (1 - s) * (1 - s) * h * d[k - 1] +
         s * s * (3 - 2 * s) * y[k] + s * s * (s - 1) * h * d[k];
}

double error(const text::TimeTable& run, const text::TimeTable& fine) {
  double most = 0.0, peak = 0.0;
  const auto& y = run.columns[column(run, "linkage.speed")];
  for (std::size_t k = 0; k < y.size(); ++k) most = std::max(most, std::abs(y[k] - at(fine, run.times[k])));
  for (const double value : fine.columns[column(fine, "linkage.speed")])
    peak = std::max(peak, std::abs(value));
  return most / peak;
}

/// Cells of the row that begins so.
std::vector<double> figures(const std::string& table, const std::string& row) {
  const auto begin = table.find("\n" + row + ",");
  EXPECT_NE(begin, std::string::npos) << row << " is not in " << table;
  std::istringstream cells(
      table.substr(begin + row.size() + 2, table.find('\n', begin + 1) - begin - row.size() - 2));
  std::vector<double> numbers;
  for (std::string cell; std::getline(cells, cell, ',') && cell != "ok";) numbers.push_back(std::stod(cell));
  return numbers;
}

TEST(Study, OfAUsersOwnTellsWhatSingleRunsGive) {
  const Scratch folder;
  folder.write("s.toml", study(axes));
  const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("16 rows, 16 ok"), std::string::npos) << said.out;
  const std::string table = read_text(folder.path() / "o/schemes.csv");
  EXPECT_TRUE(
      table.starts_with("voltage,schedule,how,step,speed_error,speed_error.floor,exchanges,status,note\n"))
      << table;
  for (const double step :
       {2e-3, 3e-3}) {  // the second is on no grid of the reference: 3e-3 = 24 * 1.25e-4 only in text
    const auto fine = speed(folder, 100, "fastest-first", "lagrange3", 1.25e-4);
    const auto finer = speed(folder, 100, "fastest-first", "lagrange3", 0.625e-4);
    const auto run = speed(folder, 100, "slowest-first", "lagrange2", step);
    const auto row = figures(table, fmt::format("100,slowest-first,lagrange2,{}", step));
    ASSERT_EQ(row.size(), 3U);
    EXPECT_NEAR(row[0], error(run, fine), 1e-12);
    EXPECT_NEAR(row[1], error(fine, finer), 1e-12);
  }
}

TEST(Study, IsTheSameBytesWhateverTheThreadsAndWhereItWasStopped) {
  const Scratch folder;
  folder.write("s.toml", study(axes));
  const std::vector<std::string> sweep = {"sweep", "s.toml", "--set", "span.stop=4", "--output"};
  const auto with = [&](std::initializer_list<std::string> more) {
    auto words = sweep;
    words.insert(words.end(), more);
    return words;
  };
  ASSERT_EQ(tandem(folder, with({"whole", "--threads", "1"})).status, 0);
  ASSERT_EQ(tandem(folder, with({"three", "--threads", "3"})).status, 0);
  const std::string whole = read_text(folder.path() / "whole/schemes.csv");
  EXPECT_EQ(read_text(folder.path() / "three/schemes.csv"), whole);
  for (const int signal : {SIGINT, SIGKILL}) {
    const std::string name = fmt::format("stopped{}", signal);
    Background first(folder, with({name, "--threads", "1"}));
    ASSERT_TRUE(first.wait_for_file(folder.path() / name / "schemes.part")) << first.err();
    while (read_text(folder.path() / name / "schemes.part").find("parallel") == std::string::npos) {
    }
    EXPECT_EQ(first.end_by(signal), signal == SIGINT ? 1 : -1);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name / "schemes.csv"));
    const Said said = tandem(folder, with({name, "--resume"}));
    ASSERT_EQ(said.status, 0) << said.err;
    EXPECT_NE(said.out.find(" kept"), std::string::npos) << said.out;
    EXPECT_EQ(read_text(folder.path() / name / "schemes.csv"), whole);
    EXPECT_EQ(read_text(folder.path() / name / "schemes.json"),
              read_text(folder.path() / "whole/schemes.json"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name / "schemes.part"));
  }
}

TEST(Study, KeepsNoRowsOfAnotherModelOrStudy) {
  const Scratch folder;
  const std::filesystem::path here = scene;
  for (const char* file : {"scene.toml", "linkage.toml", "motor.toml"})
    std::filesystem::copy_file(here.parent_path() / file, folder.path() / file);
  std::string text =
      study("{ voltage = [50] }, { schedule = ['parallel'] }, { how = ['lagrange1'] }, { step = [4e-3] }");
  text.replace(text.find(scene), scene.size(), "scene.toml");
  folder.write("s.toml", text);
  const auto resumed = [&] { return tandem(folder, {"sweep", "s.toml", "--resume", "--output", "o"}); };
  ASSERT_EQ(resumed().status, 0);
  const std::string before = read_text(folder.path() / "o/schemes.csv");
  EXPECT_NE(resumed().out.find("1 rows, 1 kept"), std::string::npos);
  EXPECT_EQ(read_text(folder.path() / "o/schemes.csv"), before);
  std::string linkage = read_text(folder.path() / "linkage.toml");
  linkage.replace(linkage.find("inertia = 0.2"), 13, "inertia = 0.3");
  folder.write("linkage.toml", linkage);
  const Said said = resumed();
  EXPECT_NE(said.err.find("made anew"), std::string::npos) << said.err;
  EXPECT_NE(read_text(folder.path() / "o/schemes.csv"), before);
}

TEST(Study, HasARowForWhatIsRefusedLostOrFails) {
  const Scratch folder;
  folder.write(
      "s.toml",
      study("{ voltage = [50] }, { schedule = ['slowest-first'] }, { how = ['lagrange1', 'hermite'] }, "
            "{ step = [1e-3, 8e-3] }",
            "odd = { formula = 'sqrt(2.1e-3 - step)*0 + speed_error' }\n[lost]\nwhen = 'speed_error > "
            "1e-9'\n"));
  ASSERT_EQ(tandem(folder, {"sweep", "s.toml", "--output", "o"}).status, 0);
  const std::string table = read_text(folder.path() / "o/schemes.csv");
  EXPECT_NE(table.find(",lost,speed_error > 1e-9\n"), std::string::npos) << table;
  EXPECT_NE(table.find(",failed,\"s.toml:18: the expression 'sqrt(2.1e-3 - step)*0 + speed_error' is "),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("hermite,0.001,,,,,refused,"), std::string::npos) << table;
}

TEST(Study, ThatIsWrongIsStatusTwoWithASentence) {
  const Scratch folder;
  const std::string few =
      "{ voltage = [50] }, { schedule = ['parallel'] }, { how = ['lagrange1'] }, { step = [4e-3] }";
  const auto says = [&](std::string text, const std::string& old, const std::string& other,
                        const std::string& sentence) {
    text.replace(text.find(old), old.size(), other);
    folder.write("s.toml", text);
    const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o"});
    EXPECT_EQ(said.status, 2) << other;
    EXPECT_NE(said.err.find(sentence), std::string::npos) << said.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "o/schemes.csv"));
  };
  const std::string good = study(few);
  says(good, "linkage.speed", "linkage.sped",
       "s.toml:16: output 'linkage.sped' is not there; did you mean 'linkage.speed'?");
  says(good, "$(step/2)", "$(stp/2)",
       "s.toml:6: set.subsystems.motor.parameters.step: column 'stp' is not there; did you mean 'step'?");
  says(good, "$(step/2)", "$(1/(step - 4e-3))",
       "s.toml:6: the expression '1/(step - 4e-3)' is inf, step = 0.004");
  says(good, "lagrange1", "lagrnge1",
       "connections[0].reconstruction is 'lagrnge1' (did you mean 'lagrange1'?)");
  says(good, "parameters.V", "parameters.W", "parameter 'W' is not there");
  says(good, "\"subsystems.motor.parameters.V\"", "\"subsystems.moter.parameters.V\"", "s.toml:4: ");
  says(good, "'lagrange1'", "'hermite'",
       "all 1 rows are refused, as (voltage = 50, schedule = parallel, how = hermite");
  says(good, "exchanges = {}", "\"steps.lnkage\" = {}",
       "subsystem 'lnkage' is not there; did you mean 'linkage'?");
  says(good, "scene.toml", "scne.toml", "s.toml:1: file");
  says(good, "step = 1.25e-4", "step = -1.25e-4", "step is -6.25e-05 s");
}

TEST(Study, TellsItsPlanAndWritesNothing) {
  const Scratch folder;
  folder.write("s.toml", study("{ voltage = [50] }, { schedule = ['parallel'] }, { how = ['lagrange1', "
                               "'hermite'] }, { step = [4e-3] }"));
  const Said said = tandem(folder, {"sweep", "s.toml", "--output", "o", "--dry-run"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_NE(said.out.find("schemes.csv: 2 rows\n"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("refused (voltage = 50, schedule = parallel, how = hermite, step = 0.004): "),
            std::string::npos);
  EXPECT_NE(said.out.find("reference fine (voltage = 50), and with half its steps"), std::string::npos)
      << said.out;
  EXPECT_NE(said.out.find(" s for references, on one processor"), std::string::npos) << said.out;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "o"));
}

/// Rows that are refused leave it to those after them.
TEST(Study, TellsAboutHowLongItTakesByTheRowsThatRun) {
  const Scratch folder;
  folder.write("s.toml", study("{ voltage = [50] }, { schedule = ['parallel'] }, { how = ['hermite', "
                               "'lagrange1'] }, { step = [4e-3, 8e-3] }"));
  const Said said = tandem(folder, {"sweep", "s.toml", "--dry-run"});
  EXPECT_NE(said.out.find("\nabout "), std::string::npos) << said.out;
  EXPECT_EQ(said.out.find("\nabout 0 s for rows"), std::string::npos) << said.out;
}

TEST(Study, OnAFullDiskIsStatusOneAndInAFolderAtWorkIsRefused) {
  const Scratch folder;
  folder.write("s.toml", study(axes));
  std::filesystem::create_directory(folder.path() / "full");
  std::filesystem::create_symlink("/dev/full", folder.path() / "full/schemes.part");
  const Said full = tandem(folder, {"sweep", "s.toml", "--output", "full"});
  EXPECT_EQ(full.status, 1);
  EXPECT_NE(full.err.find("schemes.part' can't be written: No space left"), std::string::npos) << full.err;
  Background first(folder, {"sweep", "s.toml", "--set", "span.stop=20", "--output", "o"});
  ASSERT_TRUE(first.wait_for_file(folder.path() / "o/schemes.part")) << first.err();
  const Said second = tandem(folder, {"sweep", "s.toml", "--output", "o"});
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.err.find("is being written by another tandem"), std::string::npos) << second.err;
  EXPECT_EQ(first.end_by(SIGINT), 1);
}

}  // namespace
}  // namespace tandem::study_tests
