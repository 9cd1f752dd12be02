// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The kart's levels while they move: against each other, against the printed runs, and by what must hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kart/plane.hpp"
#include "kart_run.hpp"
#include "kart_torque.hpp"

namespace tandem::test {
namespace {

using kart::KartData;
using kart::Plane;

/// Pitch [degrees] at each step.
std::vector<double> pitches(mbs::Description d, double h, double stop,
                            const mbs::StepperSettings& settings = {}) {
  KartRun run(std::move(d), h, settings);
  std::vector<double> all = {degrees * run.output("pitch")};
  for (long k = 0; k < std::lround(stop / h); ++k) {
    run.step();
    all.push_back(degrees * run.output("pitch"));
  }
  return all;
}

mbs::Description replay(const std::string& text, double scale = 1.0) {
  mbs::Description d = kart(text);
  set_input(d, "torque", [scale](double t) { return scale * kart_torque()(t); });
  return d;
}

/// Level iii as in the prototype that the specification was measured with.
std::string as_printed() {
  auto words = without_lateral;
  words.insert(words.end(), printed_lever.begin(), printed_lever.end());
  return kart_text("spatial_scalar_spin", words);
}

/// The closed formulas with that torque by the classical Runge-Kutta method, pitch at each h.
std::vector<double> closed_pitches(double scale, double h, double stop) {
  Plane model(KartData{}, kart::TyreLaw::magic_formula, Plane::Formulas::complete);
  const auto& masses = model.structure().mass.values;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  const auto rate = [&](double t, const Eigen::VectorXd& at) {
    Eigen::VectorXd k(18);
    model.torque = scale * kart_torque()(t);
    k.head(9) = at.tail(9);
    Eigen::VectorXd force(9);
    model.forces(at.data(), at.data() + 9, force.data());
    for (int i = 0; i < 9; ++i) k[9 + i] = force[i] / masses[static_cast<std::size_t>(i)];
    return k;
  };
  std::vector<double> all = {0.0};
  for (long step = 0; step < std::lround(stop / h); ++step) {
    const double t = static_cast<double>(step) * h;
    const Eigen::VectorXd k1 = rate(t, y), k2 = rate(t + h / 2, y + h / 2 * k1),
                          k3 = rate(t + h / 2, y + h / 2 * k2), k4 = rate(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    all.push_back(degrees * y[2]);
  }
  return all;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// Over the whole manoeuvre within 0.02 degrees. With half of the torque the difference is a quarter (angles
/// and travel are linear in the closed formulas); the time integration's part is far below.
TEST(KartMotion, ClosedFormulasAreThePlaneMechanismForSmallAngles) {
  const double h = 1e-3;
  const double whole = largest_difference(closed_pitches(1.0, h, 10.0),
                                          pitches(replay(kart_text("plane")), h, 10.0)),
               half = largest_difference(closed_pitches(0.5, h, 4.0),
                                         pitches(replay(kart_text("plane"), 0.5), h, 4.0)),
               full = largest_difference(closed_pitches(1.0, h, 4.0),
                                         pitches(replay(kart_text("plane")), h, 4.0));
  RecordProperty("difference", std::to_string(whole));
  RecordProperty("ratio", std::to_string(full / half));
  EXPECT_LT(whole, 0.02);
  EXPECT_NEAR(full / half, 4.0, 0.5) << full << ' ' << half;
}

/// The replay of the specification, no lateral forces: printed samples and extrema (there with 1 ms, which
/// gives them within 0.001 degrees and the maximum within 0.003; 2 ms to save time).
TEST(KartMotion, ReplayInSpaceIsThePrintedOne) {
  const auto pitch = pitches(replay(as_printed()), 2e-3, 10.0);
  const std::pair<double, double> printed[] = {{1, -0.824},  {2, -2.459}, {3, -1.492}, {4, -1.025},
                                               {4.5, 0.240}, {5, -0.875}, {6, -0.100}, {8, -0.144},
                                               {9, -1.749},  {10, -1.594}};
  for (const auto& [t, value] : printed)
    EXPECT_NEAR(pitch[static_cast<std::size_t>(std::lround(500 * t))], value, 0.01) << t;
  EXPECT_NEAR(*std::min_element(pitch.begin(), pitch.end()), -2.501, 0.01);
  EXPECT_NEAR(*std::max_element(pitch.begin(), pitch.end()), 0.807, 0.01);
}

/// 0.0002 degrees is what the specification found; 2 s hold the largest pitch.
TEST(KartMotion, ScalarSpinsMoveTheKartAsTheWholeWheelsDo) {
  EXPECT_LT(largest_difference(pitches(replay(kart_text("spatial")), 1e-3, 2.0),
                               pitches(replay(kart_text("spatial_scalar_spin")), 1e-3, 2.0)),
            3e-4);
}

TEST(KartMotion, ResultsDontHingeOnTheFormulation) {
  const std::string text = kart_text("spatial_scalar_spin");
  mbs::StepperSettings other;
  other.formulation = "index1";
  EXPECT_LT(largest_difference(pitches(replay(text), 1e-3, 1.0), pitches(replay(text), 1e-3, 1.0, other)),
            2e-3);
}

TEST(KartMotion, ErrorFallsByFourWithHalfTheStep) {
  const auto smooth = [](double t) { return 80.0 * std::pow(std::sin(3.0 * t), 2); };
  const auto end = [&](double h) {
    mbs::Description d = kart(kart_text("spatial_scalar_spin"));
    set_input(d, "torque", smooth);
    return pitches(std::move(d), h, 1.0).back();
  };
  const double fine = end(5e-4), middle = end(1e-3), coarse = end(2e-3);
  EXPECT_NEAR(std::log2((coarse - middle) / (middle - fine)), 2.0, 0.2);
}

TEST(KartMotion, SymmetricMotionStaysSymmetric) {
  KartRun run(replay(kart_text("spatial")), 2e-3);
  for (int k = 0; k < 500; ++k) run.step();
  for (const char* point : {"C", "L", "U", "T"})
    for (const char* axle : {"F", "R"}) {
      Eigen::Vector3d left = place(run.mechanism, run.state, std::string(axle) + "L_" + point);
      const Eigen::Vector3d right = place(run.mechanism, run.state, std::string(axle) + "R_" + point);
      left[1] = -left[1];
      EXPECT_LT((left - right).norm(), 1e-9) << axle << point;
    }
  EXPECT_NEAR(run.output("yaw"), 0.0, 1e-9);
  EXPECT_LT(run.output("residual"), 1e-8);
}

}  // namespace
}  // namespace tandem::test
