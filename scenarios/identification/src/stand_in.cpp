// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "stand_in.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"
#include "tandem/identification/surrogate.hpp"

namespace tandem::identification {
namespace {

class StandIn final : public Subsystem {
 public:
  StandIn(std::shared_ptr<Known> known, double step, Models::Without without,
          std::function<std::unique_ptr<Subsystem>()> open)
      : known_(std::move(known)), step_(step), without_(without), open_(std::move(open)) {}

  const SubsystemInfo& info() const override { return known_->info(); }
  bool one_thread() const override { return known_->one_thread(); }
  std::vector<std::string> remarks(double t_stop) const override {
    return real_ ? real_->remarks(t_stop) : std::vector<std::string>{};
  }

  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    const auto real = [this]() -> Subsystem& { return opened(); };
    Beginning first = known_->beginning({t_start, t_stop}, u0, real);
    if (std::any_of(u0.begin(), u0.end(), [](double u) { return std::isnan(u); })) {
      if (step_ > 0.0) first.clock.next_time = t_start + step_;  // as it will be
      return give(first, y);
    }
    known_->find({t_start, t_stop}, u0, first.clock, real);
    refuse_without(known_->stand(), without_);
    active_ = surrogate();
    if (active_ == nullptr) return (active_ = &opened())->initialize(t_start, t_stop, u0, y);
    std::vector<double> row(first.row.size());
    Samples unused(row.data(), info().row_size(), 1);
    first.clock = active_->initialize(t_start, t_stop, u0, unused);
    return give(first, y);
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    return active_->advance(t_limit, land, u, y);
  }
  /// Of what runs itself.
  std::shared_ptr<SlowModel> slow_model(std::span<const SlowLink> links) const override {
    return real_ && active_ == real_.get() ? real_->slow_model(links) : nullptr;
  }
  StateId save_state() override { return active_->save_state(); }
  Clock restore_state(StateId id) override { return active_->restore_state(id); }
  void release_state(StateId id) override { active_->release_state(id); }

 private:
  static Clock give(const Beginning& first, Samples& y) {
    std::copy(first.row.begin() + Samples::header, first.row.end(),
              y.append(first.row[0], first.row[1] != 0.0));
    return first.clock;
  }
  Subsystem& opened() {
    if (!real_) real_ = open_();
    return *real_;
  }
  /// Null: there is no model.
  Subsystem* surrogate() {
    const LinearModel* model = known_->model(step_);
    if (model && !surrogate_) surrogate_ = make_surrogate(*model, info());
    return model ? surrogate_.get() : nullptr;
  }

  std::shared_ptr<Known> known_;
  const double step_;
  const Models::Without without_;
  std::function<std::unique_ptr<Subsystem>()> open_;
  std::unique_ptr<Subsystem> real_, surrogate_;
  Subsystem* active_ = nullptr;
};

}  // namespace

std::unique_ptr<Subsystem> make_stand_in(std::shared_ptr<Known> known, double step, Models::Without without,
                                         std::function<std::unique_ptr<Subsystem>()> open) {
  return std::make_unique<StandIn>(std::move(known), step, without, std::move(open));
}

void refuse_without(const Stand& stand, Models::Without without) {
  if (without == Models::Without::refused && !stand.is_known())
    throw Error(ErrorCode::not_supported, "there is no linear model of " + stand.source + ": " + stand.why);
}

}  // namespace tandem::identification
