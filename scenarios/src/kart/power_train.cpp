// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/power_train.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace tandem::kart {
namespace {

using std::numbers::pi;

constexpr double crank_inertia = 0.16, final_drive = 1.6, efficiency = 0.95;
constexpr std::array gears = {2.393, 1.450, 1.000};
constexpr double emptied = 0.10, filled = 0.12, dwell = 0.08, lock_out = 0.3;  // [s]

double interpolated(std::span<const double> x, std::span<const double> y, double at) {
  at = std::clamp(at, x.front(), x.back());
  const auto next = std::min(std::upper_bound(x.begin(), x.end(), at), x.end() - 1);
  const auto k = static_cast<std::size_t>(next - x.begin());
  return y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]);
}

constexpr std::array plates = {0.0, 5.0, 10.0, 15.0, 25.0};  // [deg]
constexpr std::array<std::array<double, 5>, 2> up = {{{4, 6, 13, 15, 18}, {6, 9, 18, 24, 30}}},
                                               down = {{{2, 2.5, 5, 7, 9}, {4, 5, 11, 18, 20}}};  // [m/s]

double throttle_flow(double plate, double pressure) {
  const double f = 2.821 + plate * (-0.05231 + plate * (0.10299 - 0.00063 * plate)),
               q = std::min(pressure, 1.0 / pressure), g = q >= 0.5 ? 2.0 * std::sqrt(q - q * q) : 1.0;
  return pressure < 1.0 ? f * g : -f * g;
}

double pumped(double n, double p) {
  return std::max(0.0, -0.366 + 0.08979 * n * p - 0.0337 * n * p * p + 0.0001 * n * n * p);
}

/// At an air-fuel ratio of 14.6 and a spark 15 degrees before top dead centre.
double engine_torque(double charge, double n) {
  constexpr double r = 14.6, s = 15.0;
  return -181.3 + 379.36 * charge + 21.91 * r - 0.85 * r * r + 0.26 * s - 0.0028 * s * s + 0.027 * n -
         0.000107 * n * n + 0.00048 * n * s + 2.55 * s * charge - 0.05 * s * s * charge;
}

struct Converter {
  double impeller, turbine;
};

/// fill: 0 to 1.
Converter converter(double n, double turbine, double fill) {
  turbine = std::max(turbine, 0.0);
  n = std::max(n, 1.0);
  const auto capacity = [](double ratio) { return 5.34e-4 * (1.0 - std::pow(ratio, 6)); };
  if (turbine > n) {
    const double torque = -fill * capacity(n / turbine) * turbine * turbine;
    return {torque, torque};
  }
  const double torque = fill * capacity(turbine / n) * n * n;
  return {torque, std::max(1.0, 2.2 - 1.4 * turbine / n) * torque};
}

/// Where a falling function vanishes.
template <class Function>
double zero(double from, double to, const Function& f) {
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (from + to);
    (f(middle) > 0.0 ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

}  // namespace

double throttle(double t) {
  constexpr std::array times = {0.0, 0.5, 1.2, 4.0, 4.5, 7.75, 8.05, 10.0},
                       angles = {3.0, 3.0, 10.5, 10.5, 4.5, 4.5, 14.0, 14.0};
  return interpolated(times, angles, t);
}

PowerTrain::PowerTrain(double plate) : old_ratio_(gears[0]) {
  const auto pressure = [&](double n) {
    return zero(0.02, 0.9999, [&](double p) { return throttle_flow(plate, p) - pumped(n, p); });
  };
  const auto charge = [&](double n) { return pi * pumped(n, pressure(n)) / n; };
  const double n = zero(60.0, 400.0, [&](double speed) {
    return engine_torque(charge(speed), speed) - converter(speed, 0.0, 1.0).impeller;
  });
  start_ = {n, pressure(n), 0.0, 0.0};
  burnt_ = previous_ = charge(n);
}

PowerTrain::Transmission PowerTrain::transmission(double t) const {
  const double since = t - shifted_, to = gears[static_cast<std::size_t>(gear_ - 1)];
  const auto half_cosine = [](double part) { return 0.5 * (1.0 - std::cos(pi * part)); };
  if (since < emptied) return {old_ratio_ + (to - old_ratio_) * half_cosine(since / emptied), 0.0};
  if (since < emptied + filled) return {to, half_cosine((since - emptied) / filled)};
  return {to, 1.0};
}

PowerTrain::Flow PowerTrain::flow(double t, const State& y, double plate, double shaft) const {
  const auto [n, p, charge, angle] = y;
  const Transmission to = transmission(t);
  const double ratio = to.ratio * final_drive, out = pumped(n, p);
  const Converter torques = converter(n, ratio * shaft, to.fill);
  const double losses = torques.turbine >= 0.0 ? efficiency : 1.0 / efficiency;
  return {{(engine_torque(burnt_, n) - torques.impeller) / crank_inertia,
           0.41328 * (throttle_flow(plate, p) - out), out, n},
          torques.turbine * ratio * losses};
}

void PowerTrain::shift(double t, double h, double plate, double speed) {
  if (t - shifted_ < lock_out) return;
  const auto row = static_cast<std::size_t>(gear_ - 1);
  const bool up_now = gear_ < 3 && speed > interpolated(plates, up[std::min(row, std::size_t{1})], plate),
             down_now =
                 gear_ > 1 && speed < interpolated(plates, down[std::max(row, std::size_t{1}) - 1], plate);
  wants_up_ = up_now ? wants_up_ + h : 0.0;
  wants_down_ = down_now ? wants_down_ + h : 0.0;
  const bool goes_up = wants_up_ >= dwell - 1e-9, goes_down = wants_down_ >= dwell - 1e-9;
  if (!goes_up && !goes_down) return;
  old_ratio_ = gears[row];
  shifts_.push_back({t, gear_, gear_ + (goes_up ? 1 : -1), speed});
  gear_ = shifts_.back().to;
  shifted_ = t;
  wants_up_ = wants_down_ = 0.0;
}

void PowerTrain::take_charge(const State& before, State& y) {
  const double next = (half_turns_ + 1) * pi;
  if (y[3] < next) return;
  const double charge = std::lerp(before[2], y[2], (next - before[3]) / (y[3] - before[3]));
  burnt_ = previous_;
  previous_ = charge;
  y[2] -= charge;
  ++half_turns_;
}

}  // namespace tandem::kart
