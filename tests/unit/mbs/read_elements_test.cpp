// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Free coordinates, relations, slides, distances between places, and elements in files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "refusal.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::mbs {
namespace {

/// A plate on the ground's axes, and a point that slides along it by a coordinate.
const std::string text =
    "dimension = 2\n[points]\nA = { at = [0, 0], fixed = true }\nB = { at = [1, 0] }\n"
    "S = { at = [0.5, 0.2], massless = true }\n"
    "[bodies.plate]\npoints = [\"A\", \"B\"]\nmass = 1\ncentre = [0.5, 0]\ninertia = 0.1\n"
    "[coordinates]\nway = { unit = \"m\" }\nhalf = { unit = \"m\", inertia = 2 }\n"
    "[slides.s]\npoint = \"S\"\non = \"plate\"\nalong = [1, 0]\ncoordinate = \"way\"\n"
    "[relations.gear]\nterms = { way = 1, half = -2 }\n";

State stands(Mechanism& m) { return initial_state(m, 0.0); }

TEST(ReadElements, PointSlidesOnABodyByACoordinate) {
  Mechanism m(read_mechanism("slide", text + "[initial]\npositions = { half = 0.05, \"B.x\" = 0 }\n"
                                             "[drives]\n"));
  const State s = stands(m);
  EXPECT_EQ(m.structure().constraints, 4);  // one of the plate, two of the slide, the relation
  EXPECT_EQ(freedom(m, s).degrees, 2);
  // The plate stands upright, up or down; the point is 0.6 m along it and 0.2 m to its left.
  const double up = s.q[1];
  EXPECT_NEAR(std::abs(up), 1.0, 1e-9);
  EXPECT_NEAR(s.q[2], -0.2 * up, 1e-9);
  EXPECT_NEAR(s.q[3], 0.6 * up, 1e-9);
}

TEST(ReadElements, UnknownElementIsRefusedByName) {
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'drug' (did you mean 'drag'?)", "rotor or shaft"},
                            [] { read_mechanism("m", text + "[elements.air]\nkind = \"drug\"\n"); }));
}

TEST(ReadElements, KeyOfAnElementThatNobodyAsksForIsRefused) {
  EXPECT_THROW(read_mechanism(
                   "m", text + "[elements.air]\nkind = \"drag\"\npoint = \"B\"\ncoefficient = 1\narea = 2\n"),
               Error);
}

/// c |v| v on a mass of 1 kg: v = 1 / (1 / v0 + c t), what is lost is its power.
TEST(ReadElements, DragHasItsForceAndPower) {
  Mechanism m(
      read_mechanism("m",
                     "dimension = 2\n[points]\nP = { at = [0, 0], velocity = [3, 4] }\n"
                     "[masses.one]\npoint = \"P\"\nmass = 1\n[elements.air]\nkind = \"drag\"\npoint = \"P\"\n"
                     "coefficient = 0.5\n"));
  const State s = stands(m);
  double force[2];
  m.forces(s.q.data(), s.v.data(), force);
  EXPECT_DOUBLE_EQ(force[0], -7.5);
  EXPECT_DOUBLE_EQ(force[1], -10.0);
}

/// Pulls a point back to the origin by |x|^2 x + |v|^2 v in units of a length, and leaves its derivatives to
/// differences.
class Cubic final : public ForceElement {
 public:
  Cubic(std::vector<Coordinate> point, double length) : ForceElement(std::move(point), {}), length_(length) {}
  void add(const ElementState& at, double* force) const override {
    const Eigen::Vector2d x(at.x[0], at.x[1]), v(at.v[0], at.v[1]);
    Eigen::Map<Eigen::Vector2d>(force, 2) -= (x.squaredNorm() * x + v.squaredNorm() * v) / length_ / length_;
  }

 private:
  double length_;
};

void keys_of_cubic(text::KeyList& to) {
  to.need("point", text::Key::Type::text, "A point.")
      .need("length", text::Key::Type::positive, "Its length.", {.unit = "m"});
}

/// K = |x|^2 + 2 x x^T and C of the same form, x and v of one length: by differences over a millionth of it
/// to 1e-12 by curvature, and to 1e-9 by rounding where the nearest power of 1024 is a thirtieth of it.
TEST(ReadElements, ForceIsDifferentiatedByTheLengthOfItsMechanism) {
  const ElementKinds kinds = {{"cubic", {"Cubic.", keys_of_cubic, [](ElementKeys& keys) {
                                           return std::make_unique<Cubic>(keys.axes(keys.point("point")),
                                                                          keys.positive("length"));
                                         }}}};
  for (const double length : {1e-6, 1.0, 1e3, 1e6}) {
    Mechanism m(
        read_mechanism("m",
                       fmt::format("dimension = 2\n[points]\nO = {{ at = [0, 0], fixed = true }}\n"
                                   "P = {{ at = [{}, {}] }}\n[rods]\nr = {{ points = ['O', 'P'], mass = "
                                   "1 }}\n[elements.e]\nkind = 'cubic'\npoint = 'P'\nlength = {}\n",
                                   0.6 * length, 0.8 * length, length),
                       kinds));
    const Eigen::Vector2d n(0.6, 0.8), across(-0.8, 0.6), v = length * across;
    std::vector<double> k(static_cast<std::size_t>(m.structure().stiffness_values())), c(k);
    Eigen::VectorXd q = m.described_state().q, rates = Eigen::VectorXd::Zero(q.size());
    rates.head(2) = v;
    m.force_derivatives(q.data(), rates.data(), k.data(), c.data());
    const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
    EXPECT_LT((Eigen::Map<Eigen::Matrix2d>(k.data()) - one - 2.0 * n * n.transpose()).norm(), 1e-8) << length;
    EXPECT_LT((Eigen::Map<Eigen::Matrix2d>(c.data()) - one - 2.0 * across * across.transpose()).norm(), 1e-8)
        << length;
  }
}

/// y = (1 + v.v/l^2) sin(x.x/l^2) of a point, in a time unit of which one is as long as a length l.
class Wavy final : public ForceElement {
 public:
  Wavy(std::vector<Coordinate> point, double length, double time)
      : ForceElement(std::move(point), {}), length_(length), time_(time) {}
  void add(const ElementState&, double*) const override {}
  std::vector<Quantity> quantities() const override { return {{"wave", "1"}}; }
  void measure(const ElementState& at, double* values) const override {
    const Eigen::Vector2d x(at.x[0] / length_, at.x[1] / length_);
    const Eigen::Vector2d v(at.v[0] * time_ / length_, at.v[1] * time_ / length_);
    *values = (1.0 + v.squaredNorm()) * std::sin(x.squaredNorm());
  }
  static double rate(const Eigen::Vector2d& x, const Eigen::Vector2d& v, const Eigen::Vector2d& a) {
    const double square = x.squaredNorm();
    return 2.0 * v.dot(a) * std::sin(square) + (1.0 + v.squaredNorm()) * std::cos(square) * 2.0 * x.dot(v);
  }

 private:
  double length_, time_;
};

void keys_of_wavy(text::KeyList& to) {
  keys_of_cubic(to);
  to.need("time", text::Key::Type::positive, "Of a length.", {.unit = "s"});
}

const ElementKinds wavy_kind = {{"wavy", {"Wavy.", keys_of_wavy, [](ElementKeys& keys) {
                                            return std::make_unique<Wavy>(keys.axes(keys.point("point")),
                                                                          keys.positive("length"),
                                                                          keys.positive("time"));
                                          }}}};

/// The quantity's derivative by time at x, v and a, which are in these lengths and times; likewise.
double measured_rate(double length, double time, const std::array<Eigen::Vector2d, 3>& motion) {
  Mechanism m(read_mechanism(
      "m",
      fmt::format("dimension = 2\n[points]\nO = {{ at = [0, 0], fixed = true }}\nP = {{ at = [{0}, 0] }}\n"
                  "[rods]\nr = {{ points = ['O', 'P'], mass = 1 }}\n[elements.e]\nkind = 'wavy'\n"
                  "point = 'P'\nlength = {0}\ntime = {1}\n[outputs]\n"
                  "y = {{ element = 'e', quantity = 'wave' }}\n",
                  length, time),
      wavy_kind));
  Outputs outputs(m);
  State s = m.described_state();
  s.a = s.v;
  s.q.head(2) = length * motion[0];
  s.v.head(2) = length / time * motion[1];
  s.a.head(2) = length / time / time * motion[2];
  double rate = 0.0;
  outputs.derivatives(s, 1, &rate);
  return time * rate;
}

/// From a micrometre that turns a thousand million times a second to 1000 km in years, moving, at rest and
/// with a velocity that hardly changes.
TEST(ReadElements, QuantitiesHaveRatesAtAnySizeAndSpeed) {
  const Eigen::Vector2d x(0.6, 0.8), v(-1.6, 1.2), a(3.0, -2.0), none(0.0, 0.0);
  for (const double length : {1e-6, 1.0, 1e6})
    for (const double time : {1e-9, 1e-4, 1.0, 1e8})
      for (const auto& [rate, acceleration] :
           {std::pair(v, a), std::pair(none, a), std::pair(v, none), std::pair(none, none),
            std::pair(v, Eigen::Vector2d(1e-6 * a))})
        EXPECT_NEAR(measured_rate(length, time, {x, rate, acceleration}), Wavy::rate(x, rate, acceleration),
                    1e-7)
            << length << " m, " << time << " s";
}

}  // namespace
}  // namespace tandem::mbs
