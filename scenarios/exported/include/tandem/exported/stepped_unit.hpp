// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/exported/unit.hpp"

namespace tandem::exported {

/// A unit that integrates itself: FMI's Co-Simulation.
class SteppedUnit final : public Unit {
 public:
  explicit SteppedUnit(const std::filesystem::path& resources, const Tell& tell = {});

  double own_step() override;
  bool keeps_state() const override { return info_.abilities.serializes_state; }

  /// Of an input, for the next step.
  void set_derivative(std::size_t reference, int order, double value);
  /// Of an output.
  double derivative(std::size_t reference, int order);
  /// From t, where it stands, over `length` [s].
  void step(double t, double length);

 private:
  static constexpr std::int64_t most_rows = 64;  ///< of a call
  void start_source() override;
  void begin_source() override;
  /// That of the last step's end. One that follows inputs at once follows those that were set since then, as
  /// by a jump (if it changes by 1e-9 of its magnitude); before the first step each does.
  double output(const Variable& v) override;
  double output(int index, int order);
  void write_started(ByteWriter& to) override;
  void read_started(ByteReader& from, double time, const Inputs& inputs) override;
  void follow_inputs();
  void take(const Samples& y);
  double slack() const;
  void check_step(double t, double length) const;
  void run(double end, std::span<const Signal> u);
  void advance(double limit, bool land, std::span<const Signal> u);
  void run_instants(double end, std::span<const Signal> u);
  void act(double t, SamplePart part, std::span<const Signal> u);

  double own_step_ = 0.0;
  /// Where it stands by its own nodes [s]. It goes on by the same lengths as time(), so that what is added up
  /// wrongly cuts no step.
  double place_ = 0.0;
  Clock clock_{};
  std::vector<double> rows_, row_;  ///< room for a call, the newest
};

}  // namespace tandem::exported
