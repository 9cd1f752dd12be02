// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>

#include "tandem/fixed_step.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::oscillator {

/// Of one side, its own spring and damper to a wall, the coupling's to the other side.
struct Settings {
  double mass = 1.0;                ///< m [kg]
  double stiffness = 1.0;           ///< c [N/m]
  double damping = 0.0;             ///< d [N s/m]
  double coupling_stiffness = 1.0;  ///< cc [N/m]
  double coupling_damping = 0.0;    ///< dc [N s/m]
  double x = 0.0, v = 0.0;          ///< at the start [m], [m/s]
  double step = 0.01;               ///< h [s]
  bool force = true;                ///< the input is the coupling force, else the other side's motion

  /// Takes the members by name; `input` is "force" or "displacement".
  static Settings from(Parameters& parameters, bool force);
  static Words words();
};

/// One of two oscillators that a spring and a damper couple, solved exactly for inputs that are polynomials piece
/// by piece:
///   m x'' + d x' + c x = F                                                  with the input F, or
///   m x'' + (d + dc) x' + (c + cc) x = cc x_other + dc v_other              with these inputs.
/// Over a piece of length s, (x, x', p, p', p'', ..) of the right side p moves by exp(A s), A with ones above the
/// diagonal for p (C. Moler, C. Van Loan, SIAM Review 45, 2003, sect. 10).
class Side {
 public:
  explicit Side(const Settings& settings);

  SubsystemInfo info() const;
  double own_step() const { return settings_.step; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  std::optional<std::vector<StateName>> states() const {
    return std::vector<StateName>{{"x", "m"}, {"v", "m/s"}};
  }
  void get_states(std::span<double> x) const { x[0] = x_, x[1] = v_; }
  void set_states(std::span<const double> x) { x_ = x[0], v_ = x[1]; }
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  static constexpr int size = 2 + TANDEM_MAX_COEFFICIENTS;
  using Matrix = Eigen::Matrix<double, size, size>;
  const Matrix& over(double length);
  double acceleration(double push) const;

  Settings settings_;
  double stiffness_, damping_;  ///< of this side and, without `force`, of the coupling
  std::vector<double> gains_;   ///< by input: what it pushes with
  double length_ = 0.0;         ///< of the matrix
  Matrix matrix_;               ///< exp(A length)
  double x_ = 0.0, v_ = 0.0;    ///< state
  double a_ = 0.0;              ///< with the inputs at the end of the last step
};

/// oscillator.side1 (input force), oscillator.side2 (input displacement), with the names of Settings as parameters, and
/// oscillator.exact (BothSides).
void add_builtins(Builtins& builtins);

}  // namespace tandem::oscillator
