// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"
#include "two_mass/model.hpp"

namespace tandem::two_mass {

/// What a run is judged by. Errors are fractions. A figure without meaning is empty and `note` says why.
struct Figures {
  std::optional<double> position_error, energy_error, exchange_energy_error, amplitude_error, phase_error,
      position_error_exact;
  bool failed = false;
  std::string note;
};

/// Gathers the errors of a two-mass run, N fast cycles long (F. Gonzalez, doctoral thesis, A Coruna 2010,
/// chapter 5):
///   position error        (FR/N) rms((x1 - x1_exact) / x1_rms), over the fast side's nodes
///                         (where x1 has grown it saturates at FR/N)
///   position error exact  (FR/N) rms(x1 - x1_exact) / rms(x1_exact), over the same nodes
///   energy error          (FR/N) rms((E - E0) / E0), over the same nodes up to the slow side's last one; x2
///   and v2 there
///                         from the cubic Hermite polynomial of the slow side's positions and velocities
///   exchange energy error the same with the states that each side last computed, after each round
///   amplitude, phase error of the fast mode: both modes at their exact frequencies fitted to x1 by least
///   squares over
///                         the last ten fast cycles; A/C11 - 1, and the lead in rad within (-pi, pi]
/// The run has failed when a displacement exceeds 1e8 times the largest at the start.
class Measures final : public Observer {
 public:
  /// The fast side is subsystem 0 of the run with outputs x1, v1 first; the slow side is subsystem 1 with x2,
  /// v2 first. Monolithic: one subsystem with outputs x1, v1, x2, v2.
  Measures(const Model& model, double frequency_ratio, double t_stop);

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override;
  void between_rounds() override;
  /// The run ended early with this message.
  void fail(const std::string& note);

  Figures figures() const;

  /// For charts: the fast side's nodes.
  struct Node {
    double time, x1, v1;
  };
  const std::vector<Node>& nodes() const { return fast_; }
  /// (E - E0)/E0 at nodes()[0..], as far as the slow side went.
  std::vector<double> energy_errors() const;

 private:
  struct SlowNode {
    double time, x2, v2;
  };
  double limit() const { return 1e8 * largest_; }
  double scaled(double sum, std::size_t count) const;
  void set_position_errors(Figures& f) const;
  void fit_fast_mode(Figures& f) const;

  const Model& model_;
  double frequency_ratio_, t_stop_, energy0_, largest_;
  std::vector<Node> fast_;
  std::vector<SlowNode> slow_;
  double exchange_sum_ = 0.0;
  std::size_t exchanges_ = 0;
  bool failed_ = false;
  std::string note_;
};

}  // namespace tandem::two_mass
