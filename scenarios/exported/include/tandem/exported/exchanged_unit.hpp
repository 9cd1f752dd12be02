// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tandem/engine/exchanged_diagram.hpp"
#include "tandem/exported/unit.hpp"

namespace tandem::exported {

/// A unit that its importer integrates: FMI's Model Exchange (FMI 2.0, chapter 3), of a diagram alone. Time,
/// states and inputs may be set at will, and are trials until step_done() or event(). What sets throws
/// Error(wrong_state) before begin().
class ExchangedUnit final : public Unit {
 public:
  explicit ExchangedUnit(const std::filesystem::path& resources, const Tell& tell = {});

  double own_step() override;
  bool keeps_state() const override { return true; }

  std::size_t states_size() const { return static_cast<std::size_t>(diagram_->program().states); }
  std::size_t indicators_size() const { return static_cast<std::size_t>(states_->indicators); }
  void set_time(double t);
  /// Throws for another number of values than there are, as the next four do.
  void set_states(std::span<const double> x);
  void get_states(std::span<double> x);
  void get_rates(std::span<double> dx);
  /// An event is due where the sign of one changes. None is zero.
  void get_indicators(std::span<double> z);

  /// A diagram says none: 1.
  void get_nominals(std::span<double> x) const;

  /// The integrator has come here and stays.
  void step_done();
  /// Does what is due here; states, rates and indicators are to be read anew. When something is due next that
  /// is known beforehand [s]; infinity: nothing is.
  double event();

 private:
  void open_source() override;
  void start_source() override;
  double output(const Variable& v) override;
  double indicator(int number) const;
  void input_set(const Variable& v) override;
  void write_started(ByteWriter& to) override;
  void read_started(ByteReader& from, double time, const Inputs& inputs) override;
  void set_inputs(const Inputs& inputs);

  Tell tell_;
  std::unique_ptr<engine::ExchangedDiagram> diagram_;
  std::optional<ExchangedStates> states_;  ///< as it was exported
  int watched_ = 0;                        ///< events that it has now
  std::vector<double> rates_;
};

}  // namespace tandem::exported
