// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "taylor_surrogate.hpp"

#include <algorithm>
#include <cmath>

#include "coupling_times.hpp"

namespace tandem {
namespace {

TaylorCoupling checked(TaylorCoupling of) {
  check_times(of);
  require_of_coupling(of.model && !of.links.empty() && !of.velocities.empty() &&
                          of.links.size() == static_cast<std::size_t>(of.model->links()) &&
                          of.velocities.size() == of.model->coordinates().size(),
                      "the slow side's model is to have its links, and coordinates with these velocities");
  return of;
}

}  // namespace

TaylorSurrogate::TaylorSurrogate(TaylorCoupling coupling)
    : of_(checked(std::move(coupling))), model_(of_.model, of_.slow_step) {
  for (Numbers* one : {&samples_[0], &samples_[1], &samples_[2], &places_, &velocities_, &accelerations_,
                       &moved_places_, &moved_velocities_})
    one->resize(links());
  for (Numbers* one : {&stages_[0], &stages_[1], &stages_[2], &stages_[3], &reaction_, &z_, &v_, &a_, &b_})
    one->resize(size());
}

SubsystemInfo TaylorSurrogate::info() const {
  SubsystemInfo info{"taylor_surrogate", {}, {}, {}, {.serializes_state = true}};
  const int n = static_cast<int>(size());
  const auto add = [&](std::vector<Port>& to, const std::string& name,
                       std::string TaylorCoupling::Link::*unit, int derivatives) {
    for (std::size_t k = 0; k < links(); ++k)
      to.push_back(
          {links() > 1 ? name + "_" + std::to_string(k + 1) : name, of_.links[k].*unit, 1, derivatives});
  };
  add(info.inputs, "force", &TaylorCoupling::Link::force_unit, 0);
  info.inputs.push_back({"coordinates", "", n});
  add(info.outputs, "displacement", &TaylorCoupling::Link::displacement_unit, 1);
  add(info.outputs, "mean_force", &TaylorCoupling::Link::force_unit, 0);
  info.outputs.push_back({"reaction", "", n});
  if (of_.tells_velocities) add(info.outputs, "velocity", &TaylorCoupling::Link::velocity_unit, 1);
  for (int k = 0; k < static_cast<int>(links()); ++k)
    for (int i = 0; i < n; ++i) info.feedthrough.push_back({k, static_cast<int>(links()) + i});
  return info;
}

/// Coordinates that are not known yet are told later, by another start.
void TaylorSurrogate::start(double t, std::span<const double> u0) {
  std::copy_n(u0.begin() + std::ssize(of_.links), size(), z_.begin());
  begin_at(t, z_, of_.velocities);
  std::fill(reaction_.begin(), reaction_.end(), 0.0);
  passed_ = false, steps_ = 0, rest_ = {};
  slow_.start(t, of_.slow_step);
  std::fill(samples_[2].begin(), samples_[2].end(), 0.0);
  find_outputs(t);
}

void TaylorSurrogate::begin_at(double t, const Numbers& z, const Numbers& rates) {
  coordinates_.clear(), forces_.clear();
  const ForceWindow window(window_for(of_.slow_step, of_.fast_period), of_.slow_step);
  for (std::size_t i = 0; i < size(); ++i) coordinates_.emplace_back(window, z[i], rates[i]);
  for (std::size_t k = 0; k < links(); ++k) forces_.push_back({{}, window});
  model_ = TaylorModel(of_.model, of_.slow_step);
  const bool known = std::none_of(z.begin(), z.end(), [](double one) { return std::isnan(one); });
  if (known) model_.expand(t, z, rates);
}

void TaylorSurrogate::outputs(double* y) const {
  y = std::copy(places_.begin(), places_.end(), y);
  for (const Force& force : forces_) *y++ = force.mean;
  y = std::copy(reaction_.begin(), reaction_.end(), y);
  if (of_.tells_velocities) y = std::copy(velocities_.begin(), velocities_.end(), y);
  y = std::copy(velocities_.begin(), velocities_.end(), y);
  y = std::fill_n(y, links() + size(), 0.0);
  if (of_.tells_velocities) std::copy(accelerations_.begin(), accelerations_.end(), y);
}

void TaylorSurrogate::write(ByteWriter& to) const {
  to.put(slow_.begin()), to.put(std::uint8_t{passed_}), to.put(std::int32_t{steps_});
  to.put_doubles(samples_[2]), to.put_doubles(reaction_);
  for (const TaylorCoordinate& one : coordinates_) one.write(to);
  for (const Force& one : forces_) one.integrals.write(to), one.window.write(to), to.put(one.mean);
  model_.write(to), rest_.write(to);
}

void TaylorSurrogate::read(ByteReader& from) {
  slow_.begin_at(from.take<double>());
  passed_ = from.take<std::uint8_t>() != 0, steps_ = from.take<std::int32_t>();
  for (Numbers* all : {&samples_[2], &reaction_})
    for (double& one : *all) one = from.take<double>();
  for (TaylorCoordinate& one : coordinates_) one.read(from);
  for (Force& one : forces_) one.integrals.read(from), one.window.read(from), one.mean = from.take<double>();
  model_.read(from), rest_.read(from);
}

std::unique_ptr<Subsystem> taylor_surrogate(TaylorCoupling coupling) {
  return std::make_unique<FixedStep<TaylorSurrogate>>(TaylorSurrogate(std::move(coupling)));
}

}  // namespace tandem
