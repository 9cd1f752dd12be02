// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

namespace tandem::kart {

/// Plate angle of the kart's manoeuvre of 10 s [deg]: straight lines.
double throttle(double t);

/// Spark-ignition engine (P. Crossley, J. Cook, IEE Control 1991) whose charges are taken at each half turn,
/// torque converter and automatic gearbox of three gears, all in closed formulas: what the diagram of the
/// scene is checked against, and what the monolithic reference is made of. The differential states are N
/// [rad/s], P [bar], the charge that is being taken [g] and the crank's angle [rad].
class PowerTrain {
 public:
  using State = std::array<double, 4>;

  struct Flow {
    State rates;
    double torque;  ///< on the driven shaft [N m]
  };

  /// Settled at that plate angle [deg] while the shaft stands, in first gear.
  explicit PowerTrain(double plate_angle);

  const State& start() const { return start_; }
  /// plate [deg], shaft: speed of the driven shaft [rad/s].
  Flow flow(double t, const State& y, double plate, double shaft) const;
  /// What changes between steps of h: gear, by the kart's speed [m/s], at the beginning of a step.
  void shift(double t, double h, double plate, double speed);
  /// A charge is taken where the crank has passed a half turn in the step from `before` to `y`.
  void take_charge(const State& before, State& y);

  int gear() const { return gear_; }
  struct Shift {
    double time;
    int from, to;
    double speed;
  };
  const std::vector<Shift>& shifts() const { return shifts_; }

 private:
  struct Transmission {
    double ratio, fill;
  };
  Transmission transmission(double t) const;

  State start_{};
  double burnt_ = 0.0, previous_ = 0.0;  ///< charges [g]
  int half_turns_ = 0, gear_ = 1;
  double shifted_ = -1e9, old_ratio_, wants_up_ = 0.0, wants_down_ = 0.0;
  std::vector<Shift> shifts_;
};

}  // namespace tandem::kart
