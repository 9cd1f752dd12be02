// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Runs of slow sides with fast masses, and what is right there.
#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fast_masses.hpp"
#include "slow_models.hpp"
#include "tandem/coordinator/coordinator.hpp"

namespace tandem::test {

struct SlowCase {
  const char* name;
  std::function<SlowEquations(const Light&)> slow;
  double to_100, to_1000;  ///< position errors of the trials, in percent
  double amplitude = 1.0;  ///< of the fast mode
  double mass_ratio = 0.01, link_damping = 0.0;
  bool shares_mode = true;  ///< the interface starts with its part of the fast mode
};

/// One fast mass for each link; the second of another frequency.
inline FastMasses fast_side(const SlowCase& c, const Light& of, const VectorXd& y, double phase) {
  FastMasses f{0.0 * y, 0.0 * y, 0.0 * y, 0.0 * y, 1.0, 2.0 * c.link_damping * of.m1() * fast_frequency,
               0.01};
  for (Eigen::Index k = 0; k < y.size(); ++k) {
    const double a = k == 0 ? c.amplitude : 0.7 * c.amplitude, p = phase + static_cast<double>(k);
    f.mass[k] = k == 0 ? of.m1() : of.m1() / 0.49, f.ground[k] = of.w2() * of.w2() * of.m1();
    f.x0[k] = y[k] + a * std::cos(p), f.v0[k] = -fast_frequency * a * std::sin(p);
  }
  return f;
}

/// Both sides at the start.
struct StartOfCase {
  SlowEquations slow;
  FastMasses fast;
};
inline StartOfCase start_of(const SlowCase& c, double ratio, double phase) {
  const Light of{ratio, c.mass_ratio};
  SlowEquations m = c.slow(of);
  const FastMasses f = fast_side(c, of, m.displacement(m.q), phase);
  if (c.shares_mode)
    m.q[0] -= c.mass_ratio * c.amplitude * std::cos(phase),
        m.u[0] += c.mass_ratio * fast_frequency * c.amplitude * std::sin(phase);
  return {m, f};
}

/// Of each subsystem, one after the other.
class AllRows final : public Observer {
 public:
  explicit AllRows(std::size_t subsystems) : times(subsystems), values(subsystems) {}
  bool samples(int who, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t row = first; row <= last; ++row) {
      times[static_cast<std::size_t>(who)].push_back(history.time(row));
      values[static_cast<std::size_t>(who)].emplace_back(history.values(row).begin(),
                                                         history.values(row).end());
    }
    return true;
  }
  std::vector<std::vector<double>> times;
  std::vector<std::vector<std::vector<double>>> values;  ///< outputs, then derivatives
};

/// Over 100 fast cycles.
inline AllRows all_rows(const Topology& t, std::vector<Subsystem*> subsystems) {
  Coordination how;
  how.schedule = Schedule::Kind::fastest_first;
  AllRows rows(subsystems.size());
  Coordinator run(t, std::move(subsystems), how, {0.0, 100.0});
  run.observe(&rows), run.run();
  return rows;
}
/// Of the first subsystem, the fast one.
inline std::vector<std::vector<double>> fast_rows(const Topology& t, std::vector<Subsystem*> subsystems) {
  return std::move(all_rows(t, std::move(subsystems)).values[0]);
}

/// Both in one by the classical method with a quarter of the step: the rms of the difference by that of x, times FR / N.
inline double error_beside_one(const FastMasses& f, const SlowEquations& m, double ratio,
                               const std::vector<std::vector<double>>& rows) {
  VectorXd x = f.x0, v = f.v0, q = m.q, u = m.u;
  struct Rates {
    VectorXd x, v, q, u;
  };
  const auto rates = [&](const VectorXd& ax, const VectorXd& av, const VectorXd& aq, const VectorXd& au) {
    const VectorXd pull = f.force(ax, av, m.displacement(aq), m.jacobian(aq) * au);
    return Rates{av, f.acceleration(ax, av, pull), au, m.acceleration(aq, au, pull)};
  };
  double errors = 0.0, squares = x.squaredNorm();
  const double h = 0.01 / 4.0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    for (int part = 0; part < 4; ++part) {
      const auto next = [&](const Rates& r, double by) {
        return rates(x + by * r.x, v + by * r.v, q + by * r.q, u + by * r.u);
      };
      const Rates a = rates(x, v, q, u), b = next(a, h / 2), c = next(b, h / 2), d = next(c, h);
      x += h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), v += h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v);
      q += h / 6 * (a.q + 2 * b.q + 2 * c.q + d.q), u += h / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
    }
    for (Eigen::Index i = 0; i < x.size(); ++i)
      errors += std::pow(rows[k][static_cast<std::size_t>(i)] - x[i], 2), squares += x[i] * x[i];
  }
  return ratio / 100.0 * std::sqrt(errors / squares);
}

/// Ports of several links: "force_1", "y[0]".
inline std::string numbered(const std::string& port, Eigen::Index k, Eigen::Index links) {
  return links > 1 ? port + "_" + std::to_string(k + 1) : port;
}
inline std::string element(const std::string& port, Eigen::Index k, Eigen::Index size) {
  return size > 1 ? port + "[" + std::to_string(k) + "]" : port;
}

}  // namespace tandem::test
