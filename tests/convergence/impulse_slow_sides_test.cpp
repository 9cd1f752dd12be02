// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Impulse coupling of slow sides of several kinds, beside both sides in one.
#include <gtest/gtest.h>

#include <algorithm>

#include "slow_cases.hpp"
#include "tandem/coordinator/impulse/reactive_side.hpp"

namespace tandem::test {
namespace {

/// Where the fast masses integrate the surrogate along. Rows have their outputs first.
std::vector<std::vector<double>> coupled_by_reaction(const FastMasses& masses, Subsystem& slow,
                                                     ImpulseCoupling c) {
  const Eigen::Index p = masses.mass.size();
  std::vector<ReactiveLink> links;
  for (int k = 0; k < p; ++k) {
    const int n = static_cast<int>(p);
    links.push_back({.effort = {n + k}, .displacement = {k}, .velocity = ReactiveLink::End{n + k}});
  }
  c.tells_velocities = true;
  const auto fast = reactive_side(std::make_unique<FixedStep<FastMasses>>(masses), c, links, "surrogate");
  Topology t;
  t.add("fast", fast->info()), t.add("slow", slow.info()), t.add_guest("surrogate", 0);
  for (Eigen::Index k = 0; k < p; ++k) {
    t.connect({numbered("surrogate.mean_force", k, p), element("slow.F", k, p),
               Reconstruction::parse("matched_hold")});
    t.connect({element("slow.y", k, p), numbered("surrogate.position", k, p),
               Reconstruction{Reconstruction::Kind::taylor}});
    t.set_start(element("fast.y", k, p), 0.0), t.set_start(element("fast.w", k, p), 0.0);
    for (Eigen::Index i = 0; i < p; ++i)
      t.connect({element("slow.A", k * p + i, p * p), numbered(numbered("surrogate.accelerance", k, p), i, p),
                 Reconstruction::parse("hermite")});
  }
  return fast_rows(t, {fast.get(), &slow});
}

/// What a run tells besides.
struct Told {
  std::vector<std::string> remarks;
  AllRows rows{0};
};

/// By impulse, over 100 fast cycles.
std::vector<std::vector<double>> coupled(const FastMasses& masses, const SlowEquations& model, double ratio,
                                         double stiffness = 0.0, Told* told = nullptr) {
  FixedStep<SlowSide> slow(SlowSide{model, ratio / 100.0});
  const auto p = model.displacement(model.q).size();
  ImpulseCoupling c;
  c.own_step = 0.01, c.slow_step = ratio / 100.0, c.fast_period = 1.0;
  SlowSide start{model, 1.0};
  const auto n = model.q.size();
  std::vector<double> row(static_cast<std::size_t>(3 * (p + p * p + n))), none(static_cast<std::size_t>(p));
  start.start(0.0, none), start.outputs(row.data());
  const auto* const at = row.data();
  const auto cells = p * p, stride = p + cells + n;
  for (Eigen::Index k = 0; k < p; ++k) c.links.push_back({"N", "m", at[stride + k], at[2 * stride + k]});
  c.accelerance.assign(at + p, at + p + cells),
      c.accelerance_rate.assign(at + stride + p, at + stride + p + cells);
  c.accelerance_units.assign(static_cast<std::size_t>(cells), "1/kg");
  if (stiffness > 0.0) c.stiffness = {stiffness}, c.damping = {0.0}, c.trapezoidal = true;
  if (masses.reacts) return coupled_by_reaction(masses, slow, c);
  FixedStep<FastMasses> fast(masses);
  const auto surrogate = impulse_surrogate(c);
  Topology t;
  t.add("fast", fast.info()), t.add("slow", slow.info()), t.add("surrogate", surrogate->info());
  for (Eigen::Index k = 0; k < p; ++k) {
    t.connect(
        {element("fast.F", k, p), numbered("surrogate.force", k, p), Reconstruction::parse("lagrange3")});
    t.connect({numbered("surrogate.mean_force", k, p), element("slow.F", k, p),
               Reconstruction::parse("matched_hold")});
    t.connect({element("slow.y", k, p), numbered("surrogate.position", k, p),
               Reconstruction{Reconstruction::Kind::taylor}});
    t.connect({numbered("surrogate.displacement", k, p), element("fast.y", k, p),
               Reconstruction::parse("hermite")});
    for (Eigen::Index i = 0; i < p; ++i)
      t.connect({element("slow.A", k * p + i, cells), numbered(numbered("surrogate.accelerance", k, p), i, p),
                 Reconstruction::parse("hermite")});
  }
  AllRows rows = all_rows(t, {&fast, &slow, surrogate.get()});
  if (told) *told = {surrogate->remarks(100.0), rows};
  return std::move(rows.values[0]);
}

double error_of(const SlowCase& c, double ratio, double phase, bool reacts = false) {
  auto [m, f] = start_of(c, ratio, phase);
  f.reacts = reacts;
  return 100.0 * error_beside_one(f, m, ratio, coupled(f, m, ratio));
}

class ImpulseSlowSides : public ::testing::TestWithParam<SlowCase> {};

/// Within 1.5 times the errors of independent trials. By reactive inputs the same.
TEST_P(ImpulseSlowSides, AreAsTheTrialsHaveThem) {
  const SlowCase& c = GetParam();
  double to_100 = 0.0, to_1000 = 0.0;
  for (const double ratio :
       {1.5, 2.2, 4.3, 8.0, 15.0, 30.0, 45.0, 65.0, 90.0, 100.0, 150.0, 300.0, 700.0, 1000.0})
    for (const double phase : {0.0, 0.8, std::numbers::pi / 2.0}) {
      const double error = error_of(c, ratio, phase);
      if (ratio <= 100.0) to_100 = std::max(to_100, error);
      to_1000 = std::max(to_1000, error);
      if (phase != 0.8) continue;
      EXPECT_NEAR(error_of(c, ratio, phase, true), error, 0.03 * error) << ratio;
    }
  EXPECT_LT(to_100, 1.5 * c.to_100);
  EXPECT_LT(to_1000, 1.5 * c.to_1000);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ImpulseSlowSides,
    ::testing::Values(
        SlowCase{"chain", chain, 0.73, 0.97},
        SlowCase{"inner_5", [](const Light& of) { return inner(of, 5.0); }, 1.6, 1.8},
        SlowCase{"inner_10", [](const Light& of) { return inner(of, 10.0); }, 1.9, 7.0},
        SlowCase{"duffing", [](const Light& of) { return duffing(of, 0.01, 1.75); }, 0.15, 0.18},
        SlowCase{"hard_duffing", [](const Light& of) { return duffing(of, 0.1, 8.5); }, 0.15, 0.24},
        SlowCase{"pendulum", pendulum, 0.4, 29.0, 1.0, 0.01, 0.0, false},
        SlowCase{"double_pendulum", double_pendulum, 0.6, 29.0, 1.0, 0.01, 0.0, false},
        SlowCase{"rotor", rotor, 1.6, 181.0, 0.12, 0.01, 0.0, false}, SlowCase{"bar", bar, 0.24, 0.29},
        SlowCase{"damped", [](const Light& of) { return damped(of, 0.01); }, 0.15, 0.17, 1.0, 0.01, 0.002},
        SlowCase{"much_damped", [](const Light& of) { return damped(of, 0.05); }, 0.15, 0.17, 1.0, 0.01,
                 0.05}),
    [](const auto& info) { return std::string(info.param.name); });

/// Of conservative forces, by Gauss and Legendre along the line from where q is 0.
double potential(const SlowEquations& m, const VectorXd& q) {
  constexpr double places[] = {0.0, 0.5384693101056831, 0.9061798459386640},
                   weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
    for (const double sign : {-1.0, 1.0})
      sum -= (k == 0 ? 0.25 : 0.5) * weights[k] * m.force(0.5 * (1.0 + sign * places[k]) * q, 0.0 * q).dot(q);
  return sum;
}

double energy_of(const FastMasses& f, const SlowEquations& m, const VectorXd& x, const VectorXd& v,
                 const VectorXd& q, const VectorXd& u) {
  const VectorXd stretch = x - m.displacement(q);
  return 0.5 * (f.mass.dot(v.cwiseAbs2()) + f.ground.dot(x.cwiseAbs2()) +
                f.stiffness * stretch.squaredNorm() + u.dot(m.mass(q) * u)) +
         potential(m, q);
}

/// How a run moves: the fast masses at their rows, their speed by the accelerations beside; the slow side by Hermite's cubic,
/// with the ripple that its surrogate has.
class Motion {
 public:
  Motion(const FastMasses& f, const SlowEquations& m, const AllRows& rows) : f_(f), m_(m), rows_(rows) {}

  double energy(std::size_t k) {
    const VectorXd x = part(rows_.values[0][k], 0, p());
    const auto pulled = [&](std::size_t row) {
      return f_.acceleration(part(rows_.values[0][row], 0, p()), x, part(rows_.values[0][row], p(), p()));
    };
    const VectorXd v =
        (part(rows_.values[0][k + 1], 0, p()) - part(rows_.values[0][k - 1], 0, p())) / (2.0 * f_.h) -
        f_.h / 12.0 * (pulled(k + 1) - pulled(k - 1));
    take_slow(rows_.times[0][k]);
    const MatrixXd j = m_.jacobian(q_),
                   back = m_.mass(q_).llt().solve(j.transpose()) * m_.accelerance(q_).inverse();
    const VectorXd q = q_ + back * (part(rows_.values[2][k], 0, p()) - m_.displacement(q_)),
                   u = u_ + back * (part(rows_.values[2][k], 2 * p(), p()) - j * u_);
    return energy_of(f_, m_, x, v, q, u);
  }

 private:
  Eigen::Index p() const { return f_.mass.size(); }
  static VectorXd part(const std::vector<double>& row, Eigen::Index from, Eigen::Index size) {
    return Eigen::Map<const VectorXd>(row.data() + from, size);
  }
  void take_slow(double t) {
    while (next_ + 1 < rows_.times[1].size() && rows_.times[1][next_] < t) ++next_;
    const Eigen::Index n = m_.q.size(), at = p() + p() * p(), stride = at + n;
    const auto &before = rows_.values[1][next_ - 1], &after = rows_.values[1][next_];
    const double h = rows_.times[1][next_] - rows_.times[1][next_ - 1],
                 s = (t - rows_.times[1][next_ - 1]) / h;
    const VectorXd a = part(before, at, n), b = part(after, at, n), c = h * part(before, stride + at, n),
                   d = h * part(after, stride + at, n);
    q_ = a + s * c + s * s * (3.0 * (b - a) - 2.0 * c - d) + s * s * s * (2.0 * (a - b) + c + d);
    u_ = (c + 2.0 * s * (3.0 * (b - a) - 2.0 * c - d) + 3.0 * s * s * (2.0 * (a - b) + c + d)) / h;
  }

  const FastMasses& f_;
  const SlowEquations& m_;
  const AllRows& rows_;
  std::size_t next_ = 1;
  VectorXd q_, u_;
};

/// By the measure of the two-mass test, in percent, up to the last node of the slow side.
double energy_error_of(const SlowCase& c, double ratio, double phase) {
  const auto [m, f] = start_of(c, ratio, phase);
  Told told;
  coupled(f, m, ratio, 0.0, &told);
  const double first = energy_of(f, m, f.x0, f.v0, m.q, m.u), end = told.rows.times[1].back();
  Motion motion(f, m, told.rows);
  double squares = 0.0, count = 0.0;
  for (std::size_t k = 5; k + 1 < told.rows.times[0].size() && told.rows.times[0][k + 1] < end;
       k += 10, ++count)
    squares += std::pow(motion.energy(k) / first - 1.0, 2);
  return 100.0 * ratio / 100.0 * std::sqrt(squares / count);
}

struct EnergyCase {
  SlowCase of;
  double to_100, to_1000;  ///< energy errors of the trials, in percent
};
class ImpulseEnergies : public ::testing::TestWithParam<EnergyCase> {};

/// At 90 the slow steps see the fast motion as an inner mode of 10 times the slow frequency: 1.8 %.
TEST_P(ImpulseEnergies, AreAsTheTrialsHaveThem) {
  const auto& [c, at_100, at_1000] = GetParam();
  double to_100 = 0.0, to_1000 = 0.0;
  for (const double ratio : {1.5, 4.3, 15.0, 45.0, 65.0, 80.0, 100.0, 150.0, 300.0, 1000.0})
    for (const double phase : {0.0, 0.8}) {
      const double error = energy_error_of(c, ratio, phase);
      to_1000 = std::max(to_1000, error);
      if (ratio <= 100.0) to_100 = std::max(to_100, error);
    }
  EXPECT_LT(to_100, 1.5 * at_100);
  EXPECT_LT(to_1000, 1.5 * at_1000);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ImpulseEnergies,
    ::testing::Values(
        EnergyCase{{"chain", chain, 0, 0}, 0.22, 0.22},
        EnergyCase{{"inner_5", [](const Light& of) { return inner(of, 5.0); }, 0, 0}, 0.1, 0.8},
        EnergyCase{{"inner_10", [](const Light& of) { return inner(of, 10.0); }, 0, 0}, 0.3, 0.7},
        EnergyCase{{"duffing", [](const Light& of) { return duffing(of, 0.01, 1.75); }, 0, 0}, 0.15, 0.15},
        EnergyCase{{"hard_duffing", [](const Light& of) { return duffing(of, 0.1, 8.5); }, 0, 0}, 0.15, 0.15},
        EnergyCase{{"pendulum", pendulum, 0, 0, 1.0, 0.01, 0.0, false}, 0.6, 1.1},
        EnergyCase{{"double_pendulum", double_pendulum, 0, 0, 1.0, 0.01, 0.0, false}, 0.8, 1.1},
        EnergyCase{{"rotor", rotor, 0, 0, 0.12, 0.01, 0.0, false}, 1.2, 4.0},
        EnergyCase{{"bar", bar, 0, 0}, 0.20, 0.20}),
    [](const auto& info) { return std::string(info.param.of.name); });

/// With springs in the surrogate, too: they have no force where the scene starts.
TEST(ImpulseSlowSide, IsTheSameWhereTheSceneIsMoved) {
  for (const double ratio : {1.5, 4.3, 12.345, 150.0}) {
    const Light of{ratio};
    const auto rows = [&](double moved) {
      SlowEquations m = pendulum(of);
      m.displacement = [y = m.displacement, moved](const VectorXd& q) {
        return VectorXd(y(q).array() + moved);
      };
      FastMasses f = fast_side({"", pendulum, 0.0, 0.0}, of, m.displacement(m.q), 0.8);
      f.ground.setZero();
      return coupled(f, m, ratio, of.k());
    };
    const auto here = rows(0.0), there = rows(990.0);
    double largest = 0.0;
    for (std::size_t k = 0; k < here.size(); ++k)
      largest = std::max(largest, std::abs(there[k][0] - 990.0 - here[k][0]));
    EXPECT_LT(largest, 1e-6) << ratio;
  }
}

/// And nothing of one that is right.
TEST(ImpulseSlowSide, TellsOfAnAcceleranceWhoseRateIsWrong) {
  const Light of{45.0};
  SlowEquations m = pendulum(of);
  const FastMasses f = fast_side({"", pendulum, 0.0, 0.0}, of, m.displacement(m.q), 0.0);
  Told right, wrong;
  coupled(f, m, of.ratio, 0.0, &right);
  m.rate_factor = 3.0;
  coupled(f, m, of.ratio, 0.0, &wrong);
  EXPECT_TRUE(right.remarks.empty());
  ASSERT_EQ(wrong.remarks.size(), 1U);
  EXPECT_NE(wrong.remarks[0].find("the accelerance changes otherwise than its rate says"), std::string::npos)
      << wrong.remarks[0];
}

}  // namespace
}  // namespace tandem::test
