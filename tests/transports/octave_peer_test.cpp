// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Octave on either side.
#ifdef TANDEM_MEX_FOLDER
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "mass2_library.hpp"
#include "peers.hpp"
#include "recording.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"

namespace tandem::test {
namespace {

/// The same as one command of spawn:, with a deadline for the start of Octave on a busy machine.
std::string spawned_octave(const std::string& file, const std::string& parameters) {
  std::string line = "spawn:";
  for (const std::string& word : octave_program(file)) line += word + " ";
  return line + "?deadline=30" + parameters;
}

std::vector<Recording::Rows> masses_beside(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(OctavePeer, TwoMassesWithMass2InOctaveGiveTheSameBits) {
  EXPECT_TRUE(same_bits(masses_beside(spawned_octave("mass2.m", "&" + mass2_parameters(30.7))),
                        masses_beside("builtin:two_mass.slow?frequency_ratio=30.7")));
}

TEST(OctavePeer, AnErrorOfTheModelIsOneSentence) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"mass2.m", "hello", "parameter 'k' is needed"},
                      [] { open(spawned_octave("mass2.m", "&m=1"), all_sources()); }));
}

/// A model of one output, `x`, whose struct has these lines besides.
std::unique_ptr<Subsystem> small_model(const std::string& lines) {
  const Scratch folder;
  const auto file =
      folder.write("small.m",
                   "1;\nfunction m = make (p)\n  m.name = 'small';\n  m.inputs = {};\n  m.h = 1;\n"
                   "  m.start = @(t, u) 1;\n  m.step = @(x, t, e, h, u) x;\n  m.values = @(x) x;\n" +
                       lines + "endfunction\nexit (tandem_serve (@make, {}));\n");
  auto words = octave_program("mass2.m");
  words.back() = file.string();
  std::string line = "spawn:";
  for (const std::string& word : words) line += word + " ";
  return open(line + "?deadline=30", all_sources());
}

TEST(OctavePeer, OutputsHaveTheirUsualMagnitudes) {
  EXPECT_EQ(small_model("  m.outputs = {'x', 'N', 0, 2.5e5};\n")->info().outputs[0].nominal, 2.5e5);
  EXPECT_EQ(small_model("  m.outputs = {'x', 'N'};\n")->info().outputs[0].nominal, 1.0);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"a nominal value of an output is no number above 0"},
                      [] { small_model("  m.outputs = {'x', 'N', 0, -1};\n"); }));
}

TEST(OctavePeer, AFieldThatIsMisspeltIsRefused) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"the model's field 'latancy' is not known", "latency"},
                      [] { small_model("  m.outputs = {'x', 'N'};\n  m.latancy = 1;\n"); }));
}

/// What Octave prints in a folder of its own after these words of a command.
std::string printed(const std::vector<std::string>& words, const Scratch& folder) {
  std::string line = "cd '" + folder.path().string() + "' && HOME='" + folder.path().string() + "'";
  for (const std::string& word : words) line += " '" + word + "'";
  EXPECT_EQ(std::system((line + " > out.txt").c_str()), 0) << line;
  return read_text(folder.path() / "out.txt");
}

/// The rows of master.m, taken in this process.
Recording::Rows driven_here() {
  const auto slow = open("builtin:two_mass.slow", all_sources());
  const auto stride = static_cast<std::size_t>(slow->info().row_size());
  std::vector<double> memory(stride * 2000);
  Samples y(memory.data(), static_cast<std::int64_t>(stride), 2000);
  const std::vector<double> u0 = {0.5};
  slow->initialize(0.0, 100.0, u0, y);
  for (int k = 1; k <= 10; ++k) {
    const double t = 1.7 * k;
    const Segment piece = {t, t - 1.0, {0.5, 0.1 * k, -0.02}};
    const Signal u(&piece, 1, 2);
    slow->advance(t, true, {&u, 1}, y);
  }
  Recording::Rows rows;
  for (std::int64_t i = 0; i < y.size(); ++i)
    rows.emplace_back(memory.data() + i * y.c_view().stride, memory.data() + (i + 1) * y.c_view().stride);
  return rows;
}

Recording::Rows rows_of(const std::string& text) {
  Recording::Rows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    rows.emplace_back();
    for (std::string number; numbers >> number;) rows.back().push_back(std::stod(number));
  }
  return rows;
}

TEST(OctavePeer, DrivesASubsystemAsItsMasterAndGetsTheSameBits) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  const Scratch folder;
  std::vector<std::string> words = octave_program("master.m");
  words.push_back(server.address() + "?deadline=20");
  EXPECT_TRUE(same_bits({rows_of(printed(words, folder))}, {driven_here()}));
}

TEST(OctavePeer, ErrorsAreErrorsOfOctave) {
  const Scratch folder;
  const auto says = [&](const std::string& line) {
    folder.write("f.m", "try\n" + line + "\ncatch e\nprintf (\"%s: %s\", e.identifier, e.message);\nend\n");
    std::vector<std::string> words = octave_program("");
    words.back() = "f.m";
    return printed(words, folder);
  };
  const std::string open_it = "s = tandem_connect (\"spawn:" + c_mass2() + "?" + mass2_parameters() + "\"); ";
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(has(says("tandem_connect (\"unix:/none\")"),
                  "tandem:input_output: __tandem__: no connection to unix:/none"));
  EXPECT_TRUE(has(says(open_it + "tandem_save_state (s)"), "tandem:wrong_state: __tandem__: spawn:"));
  EXPECT_TRUE(has(says(open_it + "tandem_initialize (s, 0, 1, [1 2])"), "u0 has 2 numbers; allowed are 1"));
  EXPECT_TRUE(has(says(open_it + "tandem_advance (s, 1, 3)"), "no struct array of 1 elements"));
  EXPECT_TRUE(has(says(open_it + "tandem_close (s); tandem_info (s)"), "no connection that is open"));
  EXPECT_TRUE(has(says("tandem_signal (1, 2, ones (1, 7))"), "1 to 6 columns"));
  EXPECT_TRUE(has(says("printf (\"%d\", tandem_serve (@sin, \"--colour\"))"), "2"));
}

/// Rows of a CSV file below its header.
Recording::Rows rows_of_csv(const std::filesystem::path& file) {
  std::string text = read_text(file);
  text.erase(0, text.find('\n') + 1);
  std::replace(text.begin(), text.end(), ',', ' ');
  return rows_of(text);
}

TEST(OctavePeer, AGovernorInOctaveHoldsTheSpeedOfTheEngineAsItsLawSays) {
  const Scratch folder;
  printed({"env", "TANDEM_MEX_FOLDER=" TANDEM_MEX_FOLDER, TANDEM_COMMAND, "run",
           TANDEM_SOURCE_DIR "/scenarios/engine/octave_governor.toml", "--output", folder.path().string()},
          folder);
  Recording::Rows rows = rows_of_csv(folder.path() / "results.csv");
  ASSERT_EQ(rows.size(), 1002U);
  EXPECT_EQ(rows[0][6], 8.97);  // before the first sample, of the same instant
  rows.erase(rows.begin());
  double integral = 8.97;
  for (const auto& row : rows) {  // columns: time, engine.N, P, burnt, torque, half_turn, governor.throttle
    const double error = 314.16 - row[1];
    // N is about 300 and is read off a polynomial through 0.1 s of its samples: a thousand roundings.
    EXPECT_NEAR(row[6], std::clamp(0.0614 * error + integral, 0.0, 50.0), 1e3 * 300 * 2e-16);
    integral = std::clamp(integral + 0.0723 * 0.01 * error, 0.0, 50.0);
  }
  // The slower mode of the loop has gone in 10 s to a thousandth of the 105 rad/s at the start.
  EXPECT_NEAR(rows.back()[1], 314.16, 0.1);
}

TEST(OctavePeer, InstallsOfflineAsAPackage) {
  const Scratch folder;
  folder.write("offline.m", "pkg install " TANDEM_OCTAVE_PACKAGE
                            "\npkg load tandem\n"
                            "s = tandem_connect (\"spawn:" +
                                c_mass2() + "?" + mass2_parameters() +
                                "\");\nprintf (tandem_info (s).name);\n");
  EXPECT_EQ(printed({TANDEM_OCTAVE, "--quiet", "--no-history", "offline.m"}, folder), "mass2");
}

}  // namespace
}  // namespace tandem::test
#endif
