// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/builtins.hpp"

#include "kart/plane.hpp"
#include "kart/point.hpp"
#include "tandem/error.hpp"

namespace tandem::kart {
namespace {

KartSettings settings(Parameters& p) {
  KartSettings s;
  s.step = p.number("step", s.step);
  s.integrator = p.text("integrator", s.integrator);
  if (s.integrator != "rk4") s.beta = p.number("beta", s.beta);
  return s;
}

}  // namespace

void add_builtins(Builtins& builtins, const mbs::TellOfLimit& tell) {
  const Words own = words_by(Setter::client, {"step", "integrator", "beta"});
  const auto point = [](const Address&, Parameters& p) {
    return make_subsystem(std::make_shared<Point>(KartData{}), settings(p));
  };
  const auto plane = [tell](const Address&, Parameters& p) {
    const TyreLaw law = tyre_law(p.text("tyre", "magic_formula"));
    const std::string formulas = p.text("formulas", "printed");
    if (formulas != "printed" && formulas != "complete")
      throw Error(ErrorCode::invalid_argument,
                  "parameter 'formulas' is '" + formulas + "'; allowed is printed or complete");
    KartSettings s = settings(p);
    if (tell) s.tell = [tell](const std::string& text) { tell("kart.plane: " + text); };
    return make_subsystem(
        std::make_shared<Plane>(KartData{}, law,
                                formulas == "printed" ? Plane::Formulas::printed : Plane::Formulas::complete),
        s);
  };
  builtins.models["kart.point"] = {own, point};
  builtins.models["kart.plane"] = {own + words_by(Setter::client, {"tyre", "formulas"}), plane};
}

}  // namespace tandem::kart
