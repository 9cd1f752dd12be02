// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/rolling_tyre.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/text/key_list.hpp"

namespace tandem::kart {
namespace {

constexpr double slow = 0.1;  // [m/s]: below, rolling resistance and brake fade

}  // namespace

void TyreData::keys(text::KeyList& to) {
  using enum text::Key::Type;
  to.need("law", word, "How its force follows slip and load.",
          {.words = {"linear", "magic_formula", "tmeasy"}})
      .may("lever", word,
           "Where the force along acts: with `radius` what drives a wheel is what slips, `height` is as "
           "printed.",
           {.otherwise = "radius", .words = {"radius", "height"}})
      .need("axle", word, "Whose tyres it has.", {.words = {"front", "rear"}})
      .need("radius", positive, "That slip goes by.", {.unit = "m"})
      .need("free_radius", positive, "Without load.", {.unit = "m"})
      .need("stiffness", positive, "Upwards.", {.unit = "N/m"})
      .need("damping", number, "Upwards.", {.unit = "N s/m"})
      .need("rolling", number, "Coefficient of rolling resistance.")
      .need("relaxation", positive, "The length in which slip follows.", {.unit = "m"});
}

TyreData TyreData::from(mbs::ElementKeys& keys) {
  TyreData d{};
  d.law = tyre_law(keys.text("law"));
  d.lever = keys.text("lever") == "radius" ? Lever::radius : Lever::height;
  d.axle = keys.text("axle") == "front" ? Axle::front : Axle::rear;
  d.radius = keys.positive("radius");
  d.free_radius = keys.positive("free_radius");
  d.stiffness = keys.positive("stiffness");
  d.damping = keys.number("damping");
  d.rolling = keys.number("rolling");
  d.relaxation = keys.positive("relaxation");
  return d;
}

double TyreData::load(double height, double rate) const {
  if (height >= free_radius) return 0.0;
  return std::max(0.0, stiffness * (free_radius - height) - damping * rate);
}

double TyreData::excess(double load) const { return std::max(0.0, load - largest_load(law)); }

double TyreData::resistance(double load, double spin) const {
  return rolling * load * radius * std::tanh(spin * radius / slow);
}

double TyreData::resistance_rate(double load, double spin) const {
  const double t = std::tanh(spin * radius / slow);
  return rolling * load * radius * radius / slow * (1.0 - t * t);
}

double TyreData::gripping(double spin) const { return std::tanh(spin * radius / slow); }

double TyreData::gripping_rate(double part) const { return radius / slow * (1.0 - part * part); }

double TyreData::potential(double height) const {
  const double pressed = std::max(0.0, free_radius - height);
  return 0.5 * stiffness * pressed * pressed;
}

double TyreData::damping_loss(double height, double rate) const {
  return (stiffness * std::max(0.0, free_radius - height) - load(height, rate)) * rate;
}

double TyreData::damping_of_slip(double v) { return 0.05 * std::exp(-std::abs(v)); }

double TyreData::slip(double kappa, double s, double v) { return kappa + damping_of_slip(v) * s; }

double TyreData::slip_rate(double kappa, double s, double v) const {
  return (s - std::abs(v) * kappa) / relaxation;
}

Eigen::Matrix2d TyreData::slopes(const Slip& slip, double load, const TyreForce& there) const {
  constexpr double by = 1e-6;
  const TyreForce x = tyre_force(law, axle, {slip.longitudinal + by, slip.lateral}, load),
                  y = tyre_force(law, axle, {slip.longitudinal, slip.lateral + by}, load);
  Eigen::Matrix2d result;
  result << x.longitudinal - there.longitudinal, y.longitudinal - there.longitudinal,
      x.lateral - there.lateral, y.lateral - there.lateral;
  return result / by;
}

}  // namespace tandem::kart
