// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <vector>

#include "surrogate.hpp"
#include "tandem/coordinator/impulse/reactive_side.hpp"

namespace tandem {

/// What reactive_side() makes: its ports and rows, its calls (reactive_side.cpp), and its states (reactive_states.cpp).
class ReactiveSide final : public Subsystem {
 public:
  ReactiveSide(std::unique_ptr<Subsystem> fast, ImpulseCoupling coupling, std::vector<ReactiveLink> links,
               const std::string& surrogate);

  const SubsystemInfo& info() const override { return info_; }
  bool one_thread() const override { return fast_->one_thread(); }
  std::vector<std::string> remarks(double t_stop) const override;
  std::vector<Figure> figures() const override { return fast_->figures(); }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;

  std::optional<std::vector<StateName>> states() const override;
  void get_states(std::span<double> x) const override;
  void set_states(std::span<const double> x) override;
  StateId save_state() override;
  Clock restore_state(StateId id) override;
  void release_state(StateId id) override;
  std::vector<std::byte> serialize_state(StateId id) override;
  StateId deserialize_state(std::span<const std::byte> bytes) override;

 private:
  /// Of an input of the fast side that answers its outputs.
  struct Answer {
    int input;
    Segment offset;
    tandem_reactive_input reactive;
  };
  std::size_t inputs() const { return static_cast<std::size_t>(fast_->info().input_size()); }
  std::size_t outputs() const { return static_cast<std::size_t>(fast_->info().output_size()); }
  void add_ports();
  void add_answers();
  void set_inputs(std::span<const Signal> u);
  void set_reaction();
  bool can_step(double t_limit, bool land) const;
  std::int64_t steps_to(double t) const;
  double limit_for(double t_limit) const;
  Samples room_for(std::int64_t rows, std::size_t states);
  void read_forces(const Samples& rows, std::int64_t row);
  void take_rows(const Samples& rows, double before, Samples& y);
  void put_row(const Samples& rows, std::int64_t row, Samples& y);

  std::unique_ptr<Subsystem> fast_;
  std::string name_;  ///< of the surrogate
  std::vector<ReactiveLink> links_;
  Surrogate surrogate_;
  SubsystemInfo info_;
  Clock clock_{};
  TimeTolerance tolerance_;
  ReactionTerms terms_;
  Reaction reaction_{};
  std::vector<Answer> answers_;
  std::vector<Signal> of_fast_, of_surrogate_;  ///< inputs of a call
  std::vector<double> rows_, surrogate_row_, forces_;
  std::map<StateId, Surrogate> kept_;  ///< beside the states that the fast side has saved
};

}  // namespace tandem
