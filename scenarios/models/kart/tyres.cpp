// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/tyres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::kart {
namespace {

constexpr double longitudinal_grip = 0.9, lateral_grip = 1.5;

TyreForce linear(const Slip& slip, double load) {
  constexpr double longitudinal_slope = 24.7, lateral_slope = 37.0;
  const double x = longitudinal_slope * slip.longitudinal / longitudinal_grip,
               y = lateral_slope * slip.lateral / lateral_grip, used = std::max(1.0, std::hypot(x, y));
  return {longitudinal_grip * load * x / used, lateral_grip * load * y / used};
}

struct MagicFormula {
  double shape, peak, curvature, slope;  ///< C, D [N], E, K [N]
  double operator()(double slip) const {
    const double x = slope / (shape * peak) * slip;
    return peak * std::sin(shape * std::atan(x - curvature * (x - std::atan(x))));
  }
};

/// cos(atan(x)).
double cosine_of_slope(double x) { return 1.0 / std::sqrt(1.0 + x * x); }

TyreForce magic_formula(Axle axle, const Slip& slip, double load) {
  constexpr double nominal = 896.0;  // [N]
  const double off = (load - nominal) / nominal, part = load / (1.6 * nominal),
               stiffness = axle == Axle::front ? 34.1 : 37.6;
  const MagicFormula along{2.3, longitudinal_grip * load, 0.95, load * (20.0 + off) * std::exp(-0.5 * off)},
      across{axle == Axle::front ? 2.13 : 2.3, lateral_grip * load, axle == Axle::front ? 0.8 : 0.9,
             stiffness * nominal * 2.0 * part / (1.0 + part * part)};  // sin(2 atan(part))
  return {along(slip.longitudinal) * cosine_of_slope(14.0 * slip.lateral),
          across(slip.lateral) * std::cos(0.6 * std::atan(12.0 * slip.longitudinal))};
}

/// F'_0 [N], F_m [N], s_m, F_s [N]; s_s is 0.6.
struct TMeasy {
  double slope, peak, at_peak, sliding;
};
constexpr double sliding_from = 0.6, lower_load = 470.0, upper_load = 940.0;
struct Loads {
  TMeasy lower, upper;
};
constexpr Loads along{{11640, 423, 0.086, 285}, {18390, 846, 0.109, 611}},
    across_front{{18089, 705, 0.0946, 386.4}, {28021, 1410, 0.1222, 899.7}},
    across_rear{{19946, 705, 0.0823, 387.1}, {30897, 1410, 0.1063, 885.8}};

TMeasy at_load(const Loads& loads, double load) {
  const auto& [lower, upper] = loads;
  if (load < lower_load) {
    const double part = load / lower_load;
    return {part * lower.slope, part * lower.peak, lower.at_peak, part * lower.sliding};
  }
  const double part = (load - lower_load) / (upper_load - lower_load);
  return {std::lerp(lower.slope, upper.slope, part), std::lerp(lower.peak, upper.peak, part),
          std::lerp(lower.at_peak, upper.at_peak, part), std::lerp(lower.sliding, upper.sliding, part)};
}

double force(const TMeasy& t, double slip) {
  const double s = std::abs(slip), rest = t.slope * t.at_peak / t.peak - 2.0;
  if (s <= t.at_peak) {
    const double q = s / t.at_peak;
    return slip * t.slope / (1.0 + q * (q + rest));
  }
  const double q = std::min(1.0, (s - t.at_peak) / (sliding_from - t.at_peak));
  return std::copysign(t.peak - (t.peak - t.sliding) * q * q * (3.0 - 2.0 * q), slip);
}

/// Slips divided by those that are typical of them add up by Pythagoras; the force between that of both
/// directions goes along the sum.
TyreForce tmeasy(Axle axle, const Slip& slip, double load) {
  const TMeasy x = at_load(along, load), y = at_load(axle == Axle::front ? across_front : across_rear, load);
  const double x_unit = x.at_peak + x.peak / x.slope, y_unit = y.at_peak + y.peak / y.slope;
  const double sx = slip.longitudinal / x_unit, sy = slip.lateral / y_unit, s = std::hypot(sx, sy);
  if (!(s > 0.0)) return {};
  const double c = sx / s, d = sy / s;
  const auto mean = [&](double of_x, double of_y) { return std::hypot(of_x * c, of_y * d); };
  const double end = mean(sliding_from / x_unit, sliding_from / y_unit);
  const TMeasy both{mean(x.slope * x_unit, y.slope * y_unit), mean(x.peak, y.peak),
                    mean(x.at_peak / x_unit, y.at_peak / y_unit) * sliding_from / end,
                    mean(x.sliding, y.sliding)};
  const double f =
      force({both.slope * end / sliding_from, both.peak, both.at_peak, both.sliding}, s * sliding_from / end);
  return {f * c, f * d};
}

}  // namespace

TyreLaw tyre_law(const std::string& name) {
  const std::vector<std::string> known = {"linear", "magic_formula", "tmeasy"};
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end()) throw Error(ErrorCode::invalid_argument, unknown("tyre", name, known));
  return static_cast<TyreLaw>(found - known.begin());
}

TyreForce tyre_force(TyreLaw law, Axle axle, const Slip& slip, double load) {
  if (!(load > 0.0)) return {};
  const Slip s{std::clamp(slip.longitudinal, -1.0, 1.0), std::clamp(slip.lateral, -1.0, 1.0)};
  if (law == TyreLaw::linear) return linear(s, load);
  return law == TyreLaw::tmeasy ? tmeasy(axle, s, load) : magic_formula(axle, s, load);
}

double largest_load(TyreLaw law) {
  return law == TyreLaw::tmeasy ? upper_load : std::numeric_limits<double>::infinity();
}

}  // namespace tandem::kart
