// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tandem/engine/exchanged.hpp"
#include "tandem/exported/unit.hpp"

namespace tandem::exported {

/// A unit that its importer integrates: FMI's Model Exchange (FMI 2.0, chapter 3), of a diagram alone. Calls after
/// begin(). Time, states and inputs may be set at will; step_done() and event() say which of them are more than tried.
class ExchangedUnit final : public Unit {
 public:
  explicit ExchangedUnit(const std::filesystem::path& resources, const Tell& tell = {});

  void begin() override;
  double own_step() override { return diagram_->own_step(); }
  bool keeps_state() const override { return true; }

  std::size_t states_size() const { return static_cast<std::size_t>(diagram_->program().states); }
  std::size_t indicators_size() const { return diagram_->program().crossings.size(); }
  void set_time(double t);
  /// Throws for another number of values than there are, as the next three do.
  void set_states(std::span<const double> x);
  void get_states(std::span<double> x);
  void get_rates(std::span<double> dx);
  /// An event is due where the sign of one changes. None is zero.
  void get_indicators(std::span<double> z);

  /// The integrator has come here and stays.
  void step_done() { diagram_->arrive(); }
  struct Event {
    bool sets_states;
    double next;  ///< when one is due next that is known beforehand [s]; infinity: none is
  };
  /// What happens here.
  Event event();

 private:
  void source_opened() override;
  void start_source() override;
  double output(const Variable& v) override;
  void input_set(const Variable& v) override;
  void write_started(ByteWriter& to) override;
  void read_started(ByteReader& from) override;
  Equations equations() const;
  void set_inputs();

  Tell tell_;
  std::unique_ptr<engine::Exchanged> diagram_;
  std::optional<Equations> equations_;  ///< of the first
  std::vector<double> rates_, before_;
};

}  // namespace tandem::exported
