// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "running.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::fmi {
namespace {

template <class Holds>
bool all_of(const Seat& seat, const Holds& holds) {
  for (int k = seat.place; k < seat.end(); ++k)
    if (!holds(k)) return false;
  return true;
}

}  // namespace

bool take(const std::vector<Seat>& seats, std::span<const Signal> u, double t, std::vector<double>& values) {
  bool differ = false;
  for (const Seat& seat : seats)
    for (int k = seat.place; k < seat.end(); ++k) {
      double& now = values[static_cast<std::size_t>(k)];
      const double value = u[static_cast<std::size_t>(k)].value(t);
      differ = differ || value != now;
      now = value;
    }
  return differ;
}

void put_start(const std::vector<Port>& inputs, std::span<const double> u0, std::vector<double>& values) {
  std::size_t k = 0;
  for (const Port& port : inputs)
    for (int element = 0; element < port.size; ++element, ++k)
      values[k] = std::isnan(u0[k]) ? port.start_of(element) : u0[k];
}

Running::Machine::Machine(std::shared_ptr<Instance> of)
    : instance(std::move(of)),
      continuous(instance->fmu().description, instance->fmu().ports.continuous),
      discrete(instance->fmu().description, instance->fmu().ports.discrete),
      followed(instance->fmu().description, instance->fmu().ports.followed),
      asked(instance->fmu().description, instance->fmu().ports.asked),
      row(instance->fmu().description, instance->fmu().ports.row),
      derived(instance->fmu().description, instance->fmu().ports.derived),
      is_known(static_cast<std::size_t>(instance->fmu().ports.info.input_size())) {}

Running::Running(std::shared_ptr<Instance> instance)
    : machine_(std::make_shared<Machine>(std::move(instance))) {}

Running::Running(const Running& other) { *this = other; }

Running& Running::operator=(const Running& other) {
  if (this == &other) return *this;
  machine_ = other.machine_;
  kept_ = other.kept_ ? other.kept_ : KeptState::of(machine_->instance);
  hidden_ = other.hidden_;
  return *this;
}

void Running::initialize(double t, std::optional<double> t_stop, std::span<const double> u0) {
  kept_ = {};
  instance().begin(t, t_stop);
  set_known(u0, t);
  instance().end_initialization();
}

/// One by one, as some may not be known.
void Running::set_known(std::span<const double> u0, double t) {
  hidden_ = false;
  for (std::size_t k = 0; k < u0.size(); ++k) {
    machine_->is_known[k] = std::isnan(u0[k]) ? 0 : 1;
    hidden_ = hidden_ || std::isnan(u0[k]);
  }
  const auto is_known = [this](int k) { return machine_->is_known[static_cast<std::size_t>(k)] != 0; };
  for (const auto* seats : {&fmu().ports.continuous, &fmu().ports.discrete})
    for (const Seat& seat : *seats)
      if (all_of(seat, is_known)) Group(fmu().description, {seat}).set(instance(), u0.data(), t);
}

Updated Running::settle(double t) {
  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds; ++round)
    if (const Updated updated = instance().update(); updated.ended || !updated.again) return updated;
  throw Error(ErrorCode::numerical, "the FMU's event at t = " + std::to_string(t) +
                                        " s does not settle in 100 updates of its discrete states");
}

void Running::resume() {
  if (!kept_) return;
  kept_.put_back(instance());
  kept_ = {};
}

void Running::read_row(double* y) const {
  const auto outputs = static_cast<std::size_t>(info().output_size());
  if (info().derivatives() > 0)
    std::fill_n(y + outputs, outputs * static_cast<std::size_t>(info().derivatives()), 0.0);
  machine_->row.get(instance(), y);
  machine_->derived.get(instance(), y);
  if (!hidden_) return;
  for (const auto& [place, input] : fmu().ports.follows)
    if (!machine_->is_known[static_cast<std::size_t>(input)])
      y[place] = std::numeric_limits<double>::quiet_NaN();
}

void Running::write(ByteWriter& to) const {
  const std::vector<std::byte> bytes = kept_.bytes(instance());
  to.put(std::uint8_t{hidden_});
  to.put(std::uint64_t{bytes.size()});
  to.put_bytes(bytes);
}

void Running::read(ByteReader& from) {
  hidden_ = from.take<std::uint8_t>() != 0;
  const auto size = from.take<std::uint64_t>();
  kept_ = KeptState::from(machine_->instance, from.take_bytes(size));
}

}  // namespace tandem::fmi
