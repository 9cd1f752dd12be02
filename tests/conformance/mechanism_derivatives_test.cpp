// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Every element of a mechanism against differences of its own functions: Phi_q, Phi_t, gamma, K, C, and
// forces against the potential. Off the constraints too: an element's derivatives hold everywhere.
#include <gtest/gtest.h>

#include <random>

#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::string plane =
    "dimension = 2\ngravity = [1, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\nA = { at = [1, 0.2] "
    "}\n"
    "B = { at = [1.5, 1] }\nC = { at = [0.4, 0.9] }\n[bodies.bar]\npoints = ['A', 'B']\nmass = 2\ncentre = "
    "[1.2, 0.7]\n"
    "inertia = 0.3\n[masses]\nm = { point = 'C', mass = 0.5, free = true }\n[rods]\nr = { points = ['O', "
    "'A'], mass = 1 "
    "}\n";
const std::string space =
    "dimension = 3\ngravity = [1, 2, -9.81]\n[points]\nO = { at = [0, 0, 0], fixed = true }\nA = { at = [1, "
    "0.2, 0.1] }\n"
    "B = { at = [1.5, 1, 0.3] }\nP = { at = [0.4, 0.9, -0.2] }\n[vectors]\nu = { at = [1, 0, 0] }\nv = { at "
    "= [0, 1, 0] }\n"
    "w = { at = [0, 0, 1] }\nf = { at = [0, 0.6, 0.8], fixed = true }\n[bodies.box]\npoints = ['A', 'B']\n"
    "vectors = ['u', 'v', 'w']\nmass = 2\ncentre = [1.2, 0.7, 0]\ninertia = [[2, 0.1, 0], [0.1, 2, 0.2], [0, "
    "0.2, 2]]\nfree = true\n"
    "[rods]\nr = { points = ['O', 'P'], mass = 1 }\n";

struct ElementCase {
  const char* name;
  std::string text;
};

std::vector<ElementCase> element_cases() {
  std::vector<ElementCase> all = {
      {"distance", plane + "[distances]\nd = { points = ['A', 'C'], length = 1.3 }\n"},
      {"product", plane + "[products]\np = { edges = [['A', 'C'], ['O', 'B']], value = 0.3 }\n"},
      {"fixed_angle", plane + "[fixed_angles]\np = { edges = [['A', 'C'], ['C', 'B']] }\n"},
      {"angle", plane + "[angles]\nt = { from = ['A', 'C'], to = ['A', 'B'] }\n"},
      {"length", plane + "[lengths]\ns = { points = ['A', 'C'] }\n"},
      {"drive", plane + "[inputs]\nu = { unit = 'm', polynomial = [1, 2, 3] }\n[drives]\nd = { coordinate = "
                        "'C.x', motion = 'u' }\n"},
      {"spring", plane + "[springs]\ns = { points = ['A', 'C'], stiffness = [10, 3, 5], damping = [2, 0, 1], "
                         "free = 0.4 }\n"},
      {"torsion", plane + "[angles]\nt = { from = ['O', 'C'], to = ['A', 'B'] }\n[springs]\ns = { coordinate "
                          "= 't', stiffness = [7, 0, 2], damping = [1, 0.5] }\n"},
      {"actuator", plane + "[inputs]\nu = { unit = 'N', polynomial = [1, 2] }\n[forces]\nf = { between = "
                           "['O', 'C'], magnitude = 'u', gain = 2 }\n"},
      {"loads", plane + "[angles]\nt = { from = ['O', 'C'], to = ['A', 'B'] }\n[forces]\nf = { point = 'C', "
                        "direction = [1, 2], magnitude = 3 }\ng = { coordinate = 't', magnitude = 1.5 }\n"},
      {"third_point", plane + "[points.D]\nat = [1.3, 0.1]\n[bodies.more]\npoints = ['A', 'B', 'D']\nmass = "
                              "1\ncentre = [1.2, 0.7]\ninertia = 0.3\n"},
      {"space_product", space + "[products]\np = { edges = ['u', ['O', 'P']], value = 0.3 }\n"},
      {"space_distance", space + "[distances]\nd = { points = ['B', 'P'] }\n"},
      {"space_fixed_angle", space + "[fixed_angles]\np = { edges = ['f', 'v'] }\n"},
      {"space_fixed_angle_of_points", space + "[fixed_angles]\np = { edges = [['A', 'P'], ['B', 'P']] }\n"},
      {"space_angle", space + "[angles]\nt = { from = 'u', to = ['A', 'P'], axis = 'w' }\n"},
      {"space_angle_about_fixed", space + "[angles]\nt = { from = ['O', 'P'], to = 'v', axis = 'f' }\n"},
      {"space_spring", space + "[springs]\ns = { points = ['O', 'B'], stiffness = [10, 3], damping = 2 }\n"}};
  for (const char* kind : {"revolute", "prismatic", "point_on_line"})
    all.push_back({kind, plane + "[joints.j]\nkind = '" + kind +
                             "'\nbetween = ['bar', 'r']\nat = [1.1, 0.4]\n" +
                             (kind == std::string("revolute") ? "" : "axis = [1, 2]\n")});
  for (const char* kind :
       {"revolute", "prismatic", "cylindrical", "universal", "point_on_line", "point_on_plane"})
    for (const char* to : {"ground", "other"})
      all.push_back(
          {kind, space +
                     "[points.Q]\nat = [2, 0, 0]\n[vectors.a]\nat = [1, 0, 0]\n[vectors.b]\nat = [0, 1, 0]\n"
                     "[vectors.c]\nat = [0, 0, 1]\n[bodies.other]\npoints = ['Q']\nvectors = ['a', 'b', "
                     "'c']\nmass = 1\n"
                     "centre = [2, 0, 0]\ninertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nfree = "
                     "true\n[joints.j]\nkind = '" +
                     std::string(kind) + "'\nbetween = ['box', '" + to +
                     "']\nat = [1, 0.5, 0.2]\naxis = [2, 1, 2]\n" +
                     (kind == std::string("universal") ? "second_axis = [1, 0, -1]\n" : "")});
  return all;
}

class Element : public testing::TestWithParam<ElementCase> {
 protected:
  Element() : m_(read_mechanism(GetParam().name, GetParam().text)), s_(m_.structure()) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(-0.3, 0.3);
    const State start = m_.described_state();
    q_ = start.q, v_ = start.v;
    for (int i = 0; i < s_.variables; ++i) q_[i] += u(random), v_[i] += 3.0 * u(random);
    m_.at_time(0.7);
  }

  VectorXd phi(const VectorXd& q) const { return evaluated(q).first; }
  MatrixXd jacobian(const VectorXd& q) const { return evaluated(q).second; }
  VectorXd force(const VectorXd& q, const VectorXd& v) const {
    VectorXd f(s_.variables);
    m_.forces(q.data(), v.data(), f.data());
    return f;
  }
  VectorXd moved(const VectorXd& x, int i, double by) const {
    VectorXd result = x;
    result[i] += by;
    return result;
  }

  Mechanism m_;
  const Structure& s_;
  VectorXd q_, v_;
  /// Central differences of smooth functions of size 10: 1e-10 of truncation, 1e-9 of rounding.
  static constexpr double step = 1e-5, tolerance = 1e-7;

 private:
  std::pair<VectorXd, MatrixXd> evaluated(const VectorXd& q) const {
    VectorXd phi(s_.constraints);
    std::vector<double> values(static_cast<std::size_t>(s_.jacobian_values()));
    m_.constraints(q.data(), phi.data(), values.data());
    MatrixXd a = MatrixXd::Zero(s_.constraints, s_.variables);
    const auto entries = s_.jacobian.entries();
    for (std::size_t k = 0; k < entries.size(); ++k) a(entries[k].second, entries[k].first) = values[k];
    return {phi, a};
  }
};

TEST_P(Element, JacobianIsTheDerivativeOfTheConstraints) {
  const MatrixXd a = jacobian(q_);
  for (int i = 0; i < s_.variables; ++i) {
    const VectorXd slope = (phi(moved(q_, i, step)) - phi(moved(q_, i, -step))) / (2.0 * step);
    EXPECT_LT((a.col(i) - slope).lpNorm<Eigen::Infinity>(), tolerance) << s_.variable_names[i];
  }
}

TEST_P(Element, RatesAreTheDerivativeByTime) {
  VectorXd rates(s_.constraints);
  m_.constraint_rates(q_.data(), rates.data());
  m_.at_time(0.7 + step);
  const VectorXd after = phi(q_);
  m_.at_time(0.7 - step);
  EXPECT_LT((rates - (after - phi(q_)) / (2.0 * step)).lpNorm<Eigen::Infinity>(), tolerance);
}

/// gamma is what remains of Phi'' along a motion without acceleration: here by the rates of Phi' = Phi_q v +
/// Phi_t.
TEST_P(Element, GammaIsTheRestOfTheSecondDerivative) {
  VectorXd gamma(s_.constraints);
  m_.constraint_accelerations(q_.data(), v_.data(), gamma.data());
  const auto rate = [&](double by) {
    m_.at_time(0.7 + by);
    const VectorXd q = q_ + by * v_;
    VectorXd rates(s_.constraints);
    m_.constraint_rates(q.data(), rates.data());
    return VectorXd(jacobian(q) * v_.head(s_.variables) + rates);
  };
  const VectorXd difference = (rate(step) - rate(-step)) / (2.0 * step);
  EXPECT_LT((gamma - difference).lpNorm<Eigen::Infinity>(), 10.0 * tolerance);
}

TEST_P(Element, StiffnessAndDampingAreDerivativesOfTheForces) {
  std::vector<double> k(static_cast<std::size_t>(s_.stiffness_values())), c(k);
  m_.force_derivatives(q_.data(), v_.data(), k.data(), c.data());
  MatrixXd stiffness = MatrixXd::Zero(s_.variables, s_.variables), damping = stiffness;
  const auto entries = s_.stiffness.entries();
  for (std::size_t e = 0; e < entries.size(); ++e) {
    stiffness(entries[e].first, entries[e].second) = k[e];
    damping(entries[e].first, entries[e].second) = c[e];
  }
  const VectorXd still = VectorXd::Zero(v_.size());  // K leaves out what dampers do to it
  m_.force_derivatives(q_.data(), still.data(), k.data(), c.data());
  for (std::size_t e = 0; e < entries.size(); ++e) stiffness(entries[e].first, entries[e].second) = k[e];
  for (int i = 0; i < s_.variables; ++i) {
    const VectorXd by_q =
        (force(moved(q_, i, step), still) - force(moved(q_, i, -step), still)) / (2.0 * step);
    const VectorXd by_v = (force(q_, moved(v_, i, step)) - force(q_, moved(v_, i, -step))) / (2.0 * step);
    EXPECT_LT((stiffness.col(i) + by_q).lpNorm<Eigen::Infinity>(), 10.0 * tolerance);
    EXPECT_LT((damping.col(i) + by_v).lpNorm<Eigen::Infinity>(), 10.0 * tolerance);
  }
}

/// Without damping and inputs.
TEST_P(Element, ForcesAreTheSlopeOfThePotential) {
  if (!m_.description().forces.empty()) return;  // which have none
  const VectorXd still = VectorXd::Zero(v_.size()), f = force(q_, still);
  for (int i = 0; i < s_.variables; ++i) {
    const double slope =
        (m_.potential(moved(q_, i, step).data()) - m_.potential(moved(q_, i, -step).data())) / (2.0 * step);
    EXPECT_NEAR(f[i], -slope, 10.0 * tolerance) << s_.variable_names[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Element, testing::ValuesIn(element_cases()), [](const auto& p) {
  return std::string(p.param.name) + "_" + std::to_string(p.index);
});

}  // namespace
}  // namespace tandem::mbs
