// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "moving_state.hpp"
#include "own_step.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::mbs {
namespace {

/// The model of a FixedStep of any model.
class ModelBody {
 public:
  ModelBody(NamedModel named, const SubsystemSettings& settings)
      : named_(std::make_shared<const NamedModel>(std::move(named))),
        step_(settings.step),
        moving_(make_stepper(*named_->model, for_own_steps(settings))) {
    check_step("model '" + named_->name + "'", step_);
    if (!settings.dump.folder.empty())
      throw Error(ErrorCode::not_supported,
                  "model '" + named_->name + "': matrices can be written of a mechanism only");
    energy_ = std::isfinite(energy(named_->start));
  }

  SubsystemInfo info() const {
    SubsystemInfo info;
    info.name = named_->name;
    info.abilities.serializes_state = true;
    const auto& names = named_->model->structure().variable_names;
    for (std::size_t i = 0; i < names.size(); ++i) info.outputs.push_back({names[i], named_->units[i], 1, 2});
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string& unit = named_->units[i];
      info.outputs.push_back({names[i] + "_rate", unit == "1" ? "1/s" : unit + "/s", 1, 1});
    }
    if (energy_) info.outputs.push_back({"energy", "J"});
    return info;
  }
  double own_step() const { return step_; }
  void start(double t, std::span<const double>) {
    State state = named_->start;
    state.time = t;
    moving_.start(std::move(state));
  }
  void step(const OwnStep& s, std::span<const Signal>) { moving_.step(s.length, s.end); }

  /// Rows of positions, velocities and energy, then of their derivatives.
  void outputs(double* y) const {
    const State& s = moving_.state();
    const int n = named_->model->structure().variables;
    const Eigen::VectorXd* of_order[] = {&s.q, &s.v, &s.a};
    for (int order = 0; order <= 2; ++order) {
      y = std::copy_n(of_order[order]->data(), n, y);
      if (order < 2)
        y = std::copy_n(of_order[order + 1]->data(), n, y);
      else
        y = std::fill_n(y, n, 0.0);
      if (energy_) *y++ = order == 0 ? energy(s) : 0.0;
    }
  }

  void write(ByteWriter& to) const { moving_.write(to); }
  void read(ByteReader& from) { moving_.read(from); }

 private:
  double energy(const State& s) const { return named_->model->energy(s.q.data(), s.v.data()); }

  std::shared_ptr<const NamedModel> named_;
  double step_;
  bool energy_ = false;
  MovingState moving_;
};

}  // namespace

std::unique_ptr<Subsystem> make_subsystem(NamedModel model, const SubsystemSettings& settings) {
  return std::make_unique<FixedStep<ModelBody>>(ModelBody(std::move(model), settings));
}

}  // namespace tandem::mbs
