// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/functions.hpp"

#include "tandem/error.hpp"
#include "tandem/mbs/functions/function_model.hpp"
#include "tandem/mbs/functions/library.hpp"
#include "tandem/mbs/functions/octave.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/sources/stepper.hpp"

namespace tandem::functions {
namespace {

std::unique_ptr<mbs::Functions> open(const std::filesystem::path& file, Parameters& p) {
  if (file.extension() != ".m") return mbs::open_library(file);
  mbs::OctaveSettings settings;
  settings.command = p.text("octave", settings.command);
  settings.deadline = p.number("deadline", settings.deadline);
  return mbs::open_octave(file, settings);
}

std::unique_ptr<Subsystem> make(const std::filesystem::path& file, Parameters& p) {
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "model " + file.string() + " has no own step; give the parameter step, a number above 0 [s]");
  const double step = p.number("step", 0.0);
  const mbs::StepperSettings stepper = take_stepper(p);
  auto model = std::make_shared<mbs::FunctionModel>(open(file, p));
  return mbs::make_subsystem({model->info().name, model, model->initial(0.0), model->info().units},
                             {step, stepper});
}

}  // namespace

void add_sources(Builtins& builtins) { builtins.files["functions"] = make; }

}  // namespace tandem::functions
