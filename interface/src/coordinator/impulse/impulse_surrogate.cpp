// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/impulse/impulse_surrogate.hpp"

#include <algorithm>

#include "coupling_times.hpp"
#include "surrogate.hpp"

namespace tandem {
Surrogate::Surrogate(ImpulseCoupling coupling) : of_(std::move(coupling)) {
  check_times(of_);
  require_of_coupling(!of_.links.empty() && of_.accelerance.size() == of_.links.size() * of_.links.size(),
                      "the accelerance is to be a matrix of all links");
  const std::size_t matrix = of_.links.size() * of_.links.size();
  require_of_coupling(of_.stiffness.empty() ? of_.damping.empty()
                                            : of_.stiffness.size() == matrix && of_.damping.size() == matrix,
                      "stiffness and damping are to be matrices of all links");
  require_of_coupling(of_.accelerance_rate.empty() ||
                          (of_.accelerance_rate.size() == matrix && of_.accelerance_units.size() == matrix),
                      "the rate of the accelerance and its units are to be matrices of all links");
  next_ = Accelerance(of_.accelerance, std::vector<double>(matrix));
  for (Forces* one : {&forces_[0], &forces_[1], &forces_[2], &stages_[0], &stages_[1], &stages_[2],
                      &stages_[3], &net_, &positions_, &velocities_, &begin_position_, &accelerations_})
    one->resize(of_.links.size());
}

SubsystemInfo Surrogate::info() const {
  SubsystemInfo info{"impulse_surrogate", {}, {}, {}, {.serializes_state = true}};
  const auto add = [&](std::vector<Port>& to, const std::string& name,
                       std::string ImpulseCoupling::Link::*unit, int derivatives) {
    for (std::size_t k = 0; k < size(); ++k)
      to.push_back(
          {size() > 1 ? name + "_" + std::to_string(k + 1) : name, of_.links[k].*unit, 1, derivatives});
  };
  add(info.inputs, "force", &ImpulseCoupling::Link::force_unit, 0);
  add(info.inputs, "position", &ImpulseCoupling::Link::displacement_unit, 0);
  const int links = static_cast<int>(size());
  for (int e = 0; varies() && e < links * links; ++e)
    info.inputs.push_back(
        {links > 1 ? "accelerance_" + std::to_string(e / links + 1) + "_" + std::to_string(e % links + 1)
                   : "accelerance",
         of_.accelerance_units[static_cast<std::size_t>(e)]});
  add(info.outputs, "displacement", &ImpulseCoupling::Link::displacement_unit, 1);
  add(info.outputs, "mean_force", &ImpulseCoupling::Link::force_unit, 0);
  if (of_.tells_velocities) add(info.outputs, "velocity", &ImpulseCoupling::Link::velocity_unit, 1);
  for (std::size_t k = 0; k < size() && !varies(); ++k)
    info.outputs.push_back({size() > 1 ? "reaction_error_" + std::to_string(k + 1) : "reaction_error", "1"});
  for (int k = 0; k < links; ++k) info.feedthrough.push_back({k, links + k});
  return info;
}

void Surrogate::start(double t, std::span<const double> u0) {
  std::copy_n(u0.begin() + std::ssize(of_.links), size(), begin_position_.begin());
  for (std::size_t k = 0; k < size(); ++k)
    velocities_[k] = of_.links[k].velocity, accelerations_[k] = of_.links[k].free_acceleration;
  worst_ = worst_at_ = changed_ = changed_at_ = 0.0, rest_ = {};
  accelerance_ = varies() ? Accelerance(of_.accelerance, of_.accelerance_rate) : next_;
  passed_ = false;
  steps_ = 0;
  slow_.start(t, of_.slow_step);
  begin_links(velocities_, accelerations_);
}

void Surrogate::hear_of_start(std::span<const Signal> u) {
  Forces free(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const Signal& position = u[size() + k];
    velocities_[k] = position.derivative(slow_.begin()), free[k] = position.second_derivative(slow_.begin());
  }
  begin_links(velocities_, free);
}

void Surrogate::begin_links(const Forces& velocities, const Forces& free) {
  links_.clear(), checks_.clear();
  const ForceWindow window(
      of_.stiffness.empty() ? window_for(of_.slow_step, of_.fast_period) : ForceWindow::Kind::b_spline,
      of_.slow_step);
  std::fill(forces_[0].begin(), forces_[0].end(), 0.0);
  std::fill(positions_.begin(), positions_.end(), 0.0);
  take_spring(forces_[0], positions_, velocities, net_);
  accelerance_.react(net_, 0.0, stages_[0]);  // what its springs accelerate
  for (std::size_t k = 0; k < size(); ++k) {
    links_.emplace_back(window, begin_position_[k], velocities[k], free[k] - stages_[0][k]);
    if (!varies()) checks_.emplace_back(free[k]);
  }
}

void Surrogate::outputs(double* y) const {
  for (const SurrogateLink& link : links_) *y++ = link.position();
  const auto put_velocities = [&] {
    for (const SurrogateLink& link : links_) *y++ = link.velocity();
  };
  for (const SurrogateLink& link : links_) *y++ = link.mean_force();
  if (of_.tells_velocities) put_velocities();
  for (const ReactionCheck& check : checks_) *y++ = check.error();
  put_velocities();
  y = std::fill_n(y, size(), 0.0);
  if (of_.tells_velocities) y = std::copy(accelerations_.begin(), accelerations_.end(), y);
  std::fill_n(y, checks_.size(), 0.0);
}

std::unique_ptr<Subsystem> impulse_surrogate(ImpulseCoupling coupling) {
  return std::make_unique<FixedStep<Surrogate>>(Surrogate(std::move(coupling)));
}

}  // namespace tandem
