// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "functions/ways.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "functions/double_pendulum.hpp"
#include "tandem/charts/program.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/functions/function_model.hpp"
#include "tandem/mbs/functions/library.hpp"
#include "tandem/mbs/functions/octave.hpp"
#include "tandem/mbs/trajectory.hpp"
#include "tandem/output/files.hpp"

namespace tandem::functions {
namespace {

namespace fs = std::filesystem;

const fs::path octave_file = fs::path(TANDEM_FUNCTIONS_FOLDER) / "double_pendulum.m";

Outcome run(mbs::Model& model, const mbs::State& start, const Motion& m) {
  mbs::StepperSettings settings;
  settings.index3 = {.penalty = 1e8, .tolerance = 1e-5, .solver = "lapack"};
  const auto began = std::chrono::steady_clock::now();
  const mbs::Trajectory all = trajectory(model, start, settings, m.step, m.steps);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
  return {all.iterations, seconds.count(), all.q.row(m.steps), all.v.row(m.steps)};
}

Outcome run(std::unique_ptr<mbs::Functions> functions, const Motion& m) {
  mbs::FunctionModel model(std::move(functions));
  return run(model, model.initial(0.0), m);
}

Outcome run_in_cpp(const Motion& m) {
  DoublePendulum model;
  return run(model, DoublePendulum::level(), m);
}

#ifdef TANDEM_MEX_FOLDER
/// Octave drives: its script calls the multibody core.
std::string script(const Motion& m, const fs::path& result) {
  return fmt::format(
      "addpath (\"{}\", \"{}\"); tic;"
      "m = tandem_mbs (double_pendulum (), struct (\"step\", {}, \"stop\", {}, \"penalty\", 1e8,"
      " \"tolerance\", 1e-5, \"solver\", \"lapack\")); seconds = toc;"
      "f = fopen (\"{}\", \"w\"); fprintf (f, \"%d %.17g\", m.iterations, seconds);"
      "fprintf (f, \" %.17g\", m.q(end,:), m.v(end,:)); fclose (f);",
      TANDEM_MEX_FOLDER, TANDEM_FUNCTIONS_FOLDER, m.step, m.step * m.steps, result.string());
}

Outcome run_from_octave(const Motion& m) {
  const fs::path result =
      fs::temp_directory_path() /
      fmt::format("tandem_mex_{}", std::chrono::steady_clock::now().time_since_epoch().count());
  charts::run_program({"octave-cli", "--quiet", "--norc", "--eval", script(m, result)}, ".",
                      "package octave");
  Outcome outcome{0, 0.0, Eigen::VectorXd(4), Eigen::VectorXd(4)};
  std::ifstream in(result);
  in >> outcome.iterations >> outcome.seconds;
  for (double& q : outcome.q) in >> q;
  for (double& v : outcome.v) in >> v;
  const bool ok = !in.fail();
  in.close();
  fs::remove(result);
  if (!ok) throw Error(ErrorCode::internal, "Octave wrote no result of tandem_mbs");
  return outcome;
}
#endif

}  // namespace

std::vector<Way> ways() {
  return {{"cpp", run_in_cpp},
          {"pipe", [](const Motion& m) { return run(mbs::open_octave(octave_file), m); }},
          {"library", [](const Motion& m) { return run(mbs::open_library(TANDEM_FUNCTIONS_LIBRARY), m); }},
#ifdef TANDEM_MEX_FOLDER
          {"mex", run_from_octave}
#endif
  };
}

}  // namespace tandem::functions
