// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Taylor surrogates of slow sides of several kinds, beside both sides in one.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "slow_cases.hpp"
#include "tandem/coordinator/impulse/taylor_surrogate.hpp"

namespace tandem::test {
namespace {

using Numbers = std::span<const double>;

/// The model of a slow side, for its surrogate.
class ModelOfSlowSide final : public SlowModel {
 public:
  explicit ModelOfSlowSide(SlowEquations m) : m_(std::move(m)) {}
  int links() const override { return static_cast<int>(m_.displacement(m_.q).size()); }
  std::vector<std::string> coordinates() const override { return named("q"); }
  std::vector<std::string> reactions() const override { return named("reaction"); }
  std::vector<double> units() const override {
    return std::vector(static_cast<std::size_t>(m_.q.size()), 1.0);
  }
  void stand_at(double) override {}
  void accelerations(Numbers q, Numbers u, std::span<double> a) override {
    put(m_.mass(of(q)).llt().solve(m_.force(of(q), of(u))), a);
  }
  void answer(Numbers q, Numbers b, std::span<double> a) override {
    put(m_.mass(of(q)).llt().solve(of(b)), a);
  }
  void inertia(Numbers q, Numbers a, std::span<double> b) override { put(m_.mass(of(q)) * of(a), b); }
  void pushes(Numbers q, std::span<double> b) override {
    const MatrixXd all = m_.jacobian(of(q)).transpose();
    put(all.reshaped(), b);
  }
  void motions(Numbers q, Numbers u, std::span<double> y, std::span<double> rates) override {
    put(m_.displacement(of(q)), y), put(m_.jacobian(of(q)) * of(u), rates);
  }

 private:
  std::vector<std::string> named(const std::string& port) const {
    std::vector<std::string> all;
    const Port whole{port, "", static_cast<int>(m_.q.size())};
    for (int k = 0; k < whole.size; ++k) all.push_back(Scalar{&whole, k}.name());
    return all;
  }
  static VectorXd of(Numbers x) {
    return Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  }
  static void put(const VectorXd& from, std::span<double> to) {
    std::copy(from.begin(), from.end(), to.begin());
  }
  SlowEquations m_;
};

/// By a Taylor surrogate, over 100 fast cycles.
std::vector<std::vector<double>> coupled_by_taylor(const FastMasses& masses, const SlowEquations& model,
                                                   double ratio) {
  FixedStep<FastMasses> fast(masses);
  FixedStep<SlowSide> slow(SlowSide{model, ratio / 100.0, true});
  const auto p = model.displacement(model.q).size(), n = model.q.size();
  TaylorCoupling c;
  c.links.assign(static_cast<std::size_t>(p), {"N", "m"});
  c.model = std::make_shared<ModelOfSlowSide>(model), c.velocities.assign(model.u.begin(), model.u.end());
  c.own_step = 0.01, c.slow_step = ratio / 100.0, c.fast_period = 1.0, c.degree = 4;
  const auto surrogate = taylor_surrogate(c);
  Topology t;
  t.add("fast", fast.info()), t.add("slow", slow.info()), t.add("surrogate", surrogate->info());
  for (Eigen::Index k = 0; k < p; ++k) {
    t.connect(
        {element("fast.F", k, p), numbered("surrogate.force", k, p), Reconstruction::parse("lagrange4")});
    t.connect({numbered("surrogate.mean_force", k, p), element("slow.F", k, p),
               Reconstruction::parse("matched_hold")});
    t.connect({numbered("surrogate.displacement", k, p), element("fast.y", k, p),
               Reconstruction::parse("hermite")});
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::string coordinate = c.model->coordinates()[static_cast<std::size_t>(i)],
                      reaction = c.model->reactions()[static_cast<std::size_t>(i)];
    t.connect({"slow." + coordinate, element("surrogate.coordinates", i, n),
               Reconstruction{Reconstruction::Kind::taylor}});
    t.connect(
        {element("surrogate.reaction", i, n), "slow." + reaction, Reconstruction::parse("matched_hold")});
  }
  return fast_rows(t, {&fast, &slow, surrogate.get()});
}

double taylor_error_of(const SlowCase& c, double ratio, double phase) {
  const auto [m, f] = start_of(c, ratio, phase);
  return 100.0 * error_beside_one(f, m, ratio, coupled_by_taylor(f, m, ratio));
}

double largest_error(const SlowCase& c, const std::vector<double>& ratios) {
  double largest = 0.0;
  for (const double ratio : ratios)
    for (const double phase : {0.0, 0.8, std::numbers::pi / 2.0})
      largest = std::max(largest, taylor_error_of(c, ratio, phase));
  return largest;
}

class ImpulseTaylor : public ::testing::TestWithParam<SlowCase> {};

/// Within 1.5 times the errors of independent trials, which are told to a thousandth. The ratios are the page's ends, and those
/// where a slow step is close to half a fast period or to a whole one. Beyond 100 some are lost, as those trials tell.
TEST_P(ImpulseTaylor, IsAsTheTrialsHaveIt) {
  const SlowCase& c = GetParam();
  EXPECT_LT(largest_error(c, {1.5, 15.0, 49.5, 98.0, 100.0}), 1.5 * c.to_100 + 0.0005);
  if (c.to_1000 > 0.0) {
    EXPECT_LT(largest_error(c, {150.0, 1000.0}), 1.5 * c.to_1000 + 0.0005);
  }
}

constexpr double is_lost = 0.0;

INSTANTIATE_TEST_SUITE_P(
    Cases, ImpulseTaylor,
    ::testing::Values(SlowCase{"chain", chain, 0.004, 0.005},
                      SlowCase{"inner_50", [](const Light& of) { return inner(of, 50.0); }, 0.004, 0.005},
                      SlowCase{"bar", bar, 0.004, 0.026},
                      SlowCase{"heavy_chain", chain, 0.004, 0.026, 1.0, 1.0},
                      SlowCase{"heavy_inner", [](const Light& of) { return inner(of, 10.0); }, 0.004, 0.026,
                               1.0, 1.0},
                      SlowCase{"heavy_bar", bar, 0.004, 0.026, 1.0, 1.0},
                      SlowCase{"hard_duffing", [](const Light& of) { return duffing(of, 0.1, 8.5); }, 0.006,
                               0.04, 1.0, 0.1},
                      SlowCase{"pendulum", pendulum, 0.001, 0.008, 1.0, 0.01, 0.0, false},
                      SlowCase{"double_pendulum", double_pendulum, 0.001, 0.019, 1.0, 0.01, 0.0, false},
                      SlowCase{"rotor", rotor, 0.022, 5.8, 0.12, 0.01, 0.0, false},
                      SlowCase{"heavy_pendulum", pendulum, 0.019, 11.0, 1.0, 0.1, 0.0, false},
                      SlowCase{"heavy_double_pendulum", double_pendulum, 0.12, is_lost, 1.0, 0.1, 0.0, false},
                      SlowCase{"heavy_rotor", rotor, 2.3, is_lost, 0.12, 0.1, 0.0, false}),
    [](const auto& info) { return std::string(info.param.name); });

/// The surrogate has the whole of it: what is left is the force that is extrapolated.
TEST(ImpulseTaylor, IsExactForALinearSide) {
  const SlowCase c{"damped", [](const Light& of) { return damped(of, 0.05); }, 0.0, 0.0, 1.0, 1.0};
  EXPECT_LT(largest_error(c, {4.3, 30.0, 98.0}), 0.002);
}

}  // namespace
}  // namespace tandem::test
