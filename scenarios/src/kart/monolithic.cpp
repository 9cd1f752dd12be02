// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/monolithic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tandem/output/files.hpp"

namespace tandem::kart {
namespace {

struct Whole {
  PowerTrain::State engine;
  Eigen::VectorXd q, v;
};

Whole plus(const Whole& y, double by, const Whole& rate) {
  Whole sum = y;
  for (std::size_t k = 0; k < sum.engine.size(); ++k) sum.engine[k] += by * rate.engine[k];
  sum.q += by * rate.q;
  sum.v += by * rate.v;
  return sum;
}

class Run {
 public:
  Run(KartModel& kart, double scale)
      : kart_(kart), scale_(scale), train_(throttle(0.0)), row_(kart.info().row_size()) {
    const mbs::State s = kart.standing(0.0);
    at_ = {train_.start(), s.q, s.v};
  }

  Monolithic::Row step(double t, double h) {
    train_.shift(t, h, plate(t), speed_);
    const auto [k1, torque] = rate(t, at_);
    const Monolithic::Row row = record(t, k1.v, torque);
    const Whole k2 = rate(t + 0.5 * h, plus(at_, 0.5 * h, k1)).first,
                k3 = rate(t + 0.5 * h, plus(at_, 0.5 * h, k2)).first,
                k4 = rate(t + h, plus(at_, h, k3)).first;
    const PowerTrain::State before = at_.engine;
    at_ = plus(plus(plus(plus(at_, h / 6.0, k1), h / 3.0, k2), h / 3.0, k3), h / 6.0, k4);
    train_.take_charge(before, at_.engine);
    speed_ = outputs(t + h, at_, Eigen::VectorXd::Zero(at_.v.size()))[2];
    return row;
  }

  const PowerTrain& train() const { return train_; }

 private:
  double plate(double t) const { return throttle(0.0) + scale_ * (throttle(t) - throttle(0.0)); }

  const double* outputs(double t, const Whole& y, const Eigen::VectorXd& a) {
    kart_.outputs({t, y.q, y.v, a, {}}, row_.data());
    return row_.data();
  }

  std::pair<Whole, double> rate(double t, const Whole& y) {
    const double shaft = outputs(t, y, Eigen::VectorXd::Zero(y.v.size()))[0];
    const auto [rates, torque] = train_.flow(t, y.engine, plate(t), shaft);
    kart_.torque = torque;
    Whole k{rates, y.v, y.v};
    kart_.forces(y.q.data(), y.v.data(), k.v.data());
    for (int i = 0; i < k.v.size(); ++i) k.v[i] /= kart_.structure().mass.values[static_cast<std::size_t>(i)];
    return {k, torque};
  }

  Monolithic::Row record(double t, const Eigen::VectorXd& a, double torque) {
    const double* y = outputs(t, at_, a);
    return {t, torque, y[2], y[0], y[1], at_.engine[0], train_.gear()};
  }

  KartModel& kart_;
  double scale_;
  PowerTrain train_;
  std::vector<double> row_;
  Whole at_;
  double speed_ = 0.0;
};

}  // namespace

Monolithic run_monolithic(KartModel& kart, double step, double stop, double throttle_scale) {
  Run run(kart, throttle_scale);
  Monolithic result;
  for (long k = 0, last = std::lround(stop / step); k <= last; ++k)
    result.rows.push_back(run.step(static_cast<double>(k) * step, step));
  result.shifts = run.train().shifts();
  return result;
}

void write_drive(const Monolithic& run, const std::filesystem::path& file) {
  std::string text = "time,torque,speed,shaft_speed,pitch\n";
  for (const auto& row : run.rows)
    text += fmt::format("{:.10g},{:.17g},{:.17g},{:.17g},{:.17g}\n", row.time, row.torque, row.speed,
                        row.shaft_speed, row.pitch);
  output::write_text(file, text);
}

}  // namespace tandem::kart
