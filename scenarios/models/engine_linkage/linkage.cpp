// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/linkage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tandem/error.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::engine_linkage {
namespace {

int loops_of(Parameters& parameters) {
  const double loops = parameters.number("loops", 1.0);
  if (!(loops >= 1.0 && loops <= 1e6 && loops == std::floor(loops)))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("parameter 'loops' is {}; allowed are 1, 2, ... 1000000", loops));
  return static_cast<int>(loops);
}

std::string linkage_text(int loops) {
  std::string text = "name = \"linkage\"\ndimension = 2\ngravity = [0, -9.81]\n[points]\n";
  for (int i = 0; i <= loops; ++i) text += fmt::format("B{0} = {{ at = [{0}, 1], velocity = [30, 0] }}\n", i);
  for (int i = 0; i <= loops; ++i) text += fmt::format("A{0} = {{ at = [{0}, 0], fixed = true }}\n", i);
  text +=
      "[bodies]\ncrank0 = { points = [\"A0\", \"B0\"], mass = 1, centre = [0, 0.5], inertia = "
      "14.083333333333334 }\n[rods]\n";
  for (int i = 1; i <= loops; ++i)
    text += fmt::format("crank{0} = {{ points = [\"A{0}\", \"B{0}\"], mass = 1 }}\n", i);
  for (int i = 0; i < loops; ++i)
    text += fmt::format("coupler{0} = {{ points = [\"B{0}\", \"B{1}\"], mass = 1 }}\n", i, i + 1);
  return text +
         "[angles]\nturn = { from = [\"A0\", \"B0\"], to = [\"A0\", \"A1\"] }\n"
         "[inputs]\ntorque = { unit = \"N m\" }\n"
         "[springs]\nbearing = { coordinate = \"turn\", damping = 3.18 }\n"
         "[forces]\nengine = { coordinate = \"turn\", magnitude = \"torque\" }\n"
         "[outputs]\nspeed = { velocity = \"turn\" }\nangle = { position = \"turn\" }\n"
         "energy = { energy = \"total\" }\n";
}

}  // namespace

std::unique_ptr<Subsystem> make_linkage(Parameters& parameters, const mbs::TellOfLimit& tell) {
  const std::string text = linkage_text(loops_of(parameters));
  return make_mechanism({"linkage", text}, parameters, {}, tell);
}

void add_builtins(Builtins& builtins, const mbs::TellOfLimit& tell) {
  builtins.models["engine_linkage.linkage"] = {
      words_by(Setter::client, {"loops"}) + mechanism_source().words,
      [tell](const Address&, Parameters& parameters) { return make_linkage(parameters, tell); }};
}

}  // namespace tandem::engine_linkage
