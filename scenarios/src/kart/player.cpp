// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/player.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "tandem/fixed_step.hpp"

namespace tandem::kart {
namespace {

/// The model of a FixedStep.
class Player {
 public:
  Player(std::vector<double> torque, double step)
      : torque_(std::make_shared<const std::vector<double>>(std::move(torque))), step_(step) {}

  SubsystemInfo info() const { return {"player", {}, {{"torque", "N m"}}, {}, {.serializes_state = true}}; }
  double own_step() const { return step_; }
  void start(double t, std::span<const double>) { begin_ = t, row_ = 0; }
  void step(const OwnStep& s, std::span<const Signal>) {
    row_ = static_cast<std::size_t>(std::llround((s.end - begin_) / step_));
    if (row_ >= torque_->size())
      throw Error(ErrorCode::invalid_argument,
                  "the record of the torque ends before t = " + std::to_string(s.end) + " s");
  }
  void outputs(double* y) const { y[0] = (*torque_)[row_]; }
  void write(ByteWriter& to) const { to.put(static_cast<std::uint64_t>(row_)); }
  void read(ByteReader& from) {
    row_ = from.take<std::uint64_t>();
    if (row_ >= torque_->size())
      from.refuse("stands at row " + std::to_string(row_) + " of a record of " +
                  std::to_string(torque_->size()));
  }

 private:
  std::shared_ptr<const std::vector<double>> torque_;
  double step_, begin_ = 0.0;
  std::size_t row_ = 0;
};

}  // namespace

std::unique_ptr<Subsystem> make_player(std::vector<double> torque, double step) {
  return std::make_unique<FixedStep<Player>>(Player(std::move(torque), step));
}

}  // namespace tandem::kart
