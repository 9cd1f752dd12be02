// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The table [run] of a mechanism: how it runs alone, and the settings that a scenario may give it in its
// place.
#include <fmt/format.h>

#include "keys.hpp"
#include "tandem/mbs/make_stepper.hpp"

namespace tandem::mbs {
namespace {

using text::KeyList;

std::string number_text(double value) { return fmt::format("{}", value); }

void keys_of_iterations(KeyList& to, const StepperSettings& s) {
  using enum text::Key::Type;
  to.may("tolerance", positive,
         "Where the iteration of a step ends. Without it: `index3` and `newmark` 1e-10 of the mechanism's "
         "length (`newmark`: in a second), `index1` 1e-12.",
         {.unit = "m, or m/s"})
      .may("most_iterations", number, "Of a step; then it has failed.",
           {.otherwise = number_text(s.index3.most_iterations)})
      .may("multiplier_iterations", number,
           "Of these update the multipliers (`index3`); of an evaluation (`index1`).",
           {.otherwise = number_text(s.index3.multiplier_iterations)})
      .may("projections", number, "Of velocities and accelerations, at most (`index3`).",
           {.otherwise = number_text(s.index3.projections)})
      .may("carry_multipliers", flag, "A step begins with the multipliers of the one before, not with zero.",
           {.otherwise = "false"});
}

void keys_of_schemes(KeyList& to, const StepperSettings& s) {
  using enum text::Key::Type;
  to.may("penalty", positive,
         "Of violated constraints. Without it 1e7 times the largest mass, more for steps below 1 ms "
         "(`index3`).")
      .may("beta", number, "Newmark's; 0.25 is the trapezoidal rule.",
           {.otherwise = number_text(s.index3.beta), .allowed = "1/12 to 1/4"})
      .may("spectral_radius", number,
           "What `generalized_alpha` leaves of the highest frequencies after a step.",
           {.otherwise = number_text(s.generalized_alpha.spectral_radius), .allowed = "0 to 1"})
      .may("xi", number, "Baumgarte's damping ratio (`penalty`, `index1`).",
           {.otherwise = number_text(s.penalty.xi)})
      .may("omega", number, "Baumgarte's frequency (`penalty`, `index1`).",
           {.unit = "rad/s", .otherwise = number_text(s.penalty.omega)});
}

}  // namespace

void keys_of_runs(KeyList& to) {
  using enum text::Key::Type;
  const StepperSettings s;
  to.table("run",
           "How it runs alone, and its settings where a scenario says nothing else: these are `parameters` "
           "there.")
      .may("start", number, "The begin of the run.", {.unit = "s", .otherwise = "0.0"})
      .may("stop", number, "Its end, which it has to have to be run alone.", {.unit = "s"})
      .may("step", positive, "Its own step, which has to stand here or in the scenario.", {.unit = "s"})
      .may("formulation", word, "Of the equations of motion.",
           {.otherwise = s.formulation, .words = {"index1", "index3", "null_space", "penalty"}})
      .may("integrator", word, "Of time; `index3` has `newmark` merged in.",
           {.otherwise = s.integrator, .words = {"generalized_alpha", "newmark", "rk2", "rk4", "rk8"}});
  keys_of_iterations(to, s);
  keys_of_schemes(to, s);
  to.may("solver", text, "Of linear systems: a name that docs/sparse.md lists.",
         {.otherwise = s.index3.solver})
      .may("threads", number, "That share the loops over a large mechanism (`index3`).",
           {.otherwise = number_text(s.index3.threads), .allowed = "1 to 256"})
      .may("threads_from", number, "Loops over fewer elements are not shared.",
           {.otherwise = number_text(s.index3.threads_from)})
      .may("animate", flag, "Outputs tell where all points are, for `tandem view`; run alone it is true.",
           {.otherwise = "false"})
      .may("accelerances", text,
           "Outputs of these names tell what an input of 1 accelerates at a displacement "
           "(docs/impulse_coupling.md).",
           {.allowed = "\"x.by.F\", with commas between"})
      .may("reactions", text,
           "Of these positions, and of as many coordinates as the others follow, an output `coordinate.NAME` "
           "and an "
           "input `reaction.NAME`, for `impulse_taylor` (docs/impulse_coupling.md).",
           {.allowed = "names of outputs, with commas between"})
      .may("matrices", text, "A folder that matrices of its steps are written to.")
      .may("matrices_at", text, "When, with commas between; without it at the start.", {.unit = "s"})
      .may("matrices_format", word, "Of these files.", {.otherwise = "mtx", .words = {"ccs", "mtx"}})
      .may("NAME", value, "A parameter of the file.");
}

}  // namespace tandem::mbs
