// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/functions.hpp"

#include <optional>

#include "tandem/error.hpp"
#include "tandem/mbs/functions/function_model.hpp"
#include "tandem/mbs/functions/library.hpp"
#include "tandem/mbs/functions/octave.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/sources/stepper.hpp"

namespace tandem {
namespace {

/// What the parameters say, and whether the file is there.
struct Asked {
  double step;
  mbs::StepperSettings stepper;
  std::optional<mbs::OctaveSettings> octave;  ///< none: a library
};

Asked asked(const std::filesystem::path& file, Parameters& p) {
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "model " + file.string() + " has no own step; give the parameter step, a number above 0 [s]");
  Asked a{p.number("step", 0.0), take_stepper(p), {}};
  if (file.extension() == ".m") {
    a.octave.emplace();
    a.octave->command = p.text("octave", a.octave->command);
    a.octave->deadline = p.number("deadline", a.octave->deadline);
  }
  if (!std::filesystem::exists(file))
    throw Error(ErrorCode::input_output, "model " + file.string() + " is not there");
  return a;
}

std::unique_ptr<Subsystem> make(const Address& address, Parameters& p) {
  const std::filesystem::path file = address.file();
  const Asked a = asked(file, p);
  auto model = std::make_shared<mbs::FunctionModel>(a.octave ? mbs::open_octave(file, *a.octave)
                                                             : mbs::open_library(file));
  return mbs::make_subsystem({model->info().name, model, model->initial(0.0), model->info().units},
                             {a.step, a.stepper});
}

}  // namespace

Source functions_source() {
  const Words own =
      words_by(Setter::operator_only, {"octave", "deadline"}) + words_by(Setter::client, {"step"});
  return {own + stepper_words(),
          make,
          false,
          true,
          [](const Address& address, Parameters& p) -> std::optional<Look> {
            asked(address.file(), p);
            return std::nullopt;
          },
          true};
}

}  // namespace tandem
