// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "reactive_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling_times.hpp"

namespace tandem {
ReactiveSide::ReactiveSide(std::unique_ptr<Subsystem> fast, ImpulseCoupling coupling,
                           std::vector<ReactiveLink> links, const std::string& surrogate)
    : fast_(std::move(fast)),
      name_(surrogate),
      links_(std::move(links)),
      surrogate_(std::move(coupling)),
      terms_(SurrogateLink::states * links_.size()),
      of_fast_(inputs()),
      forces_(links_.size()) {
  require_of_coupling(links_.size() == surrogate_.size(), "the fast side has another number of links");
  require_of_coupling(fast_->info().abilities.reactive_inputs, "the fast side has no reactive inputs");
  add_ports();
  of_surrogate_.resize(static_cast<std::size_t>(surrogate_.info().input_size()));
  surrogate_row_.resize(static_cast<std::size_t>(surrogate_.info().row_size() - Samples::header));
  add_answers();
}

void ReactiveSide::add_ports() {
  const SubsystemInfo more = surrogate_.info();
  const auto links = static_cast<int>(links_.size()), inputs = fast_->info().input_size();
  info_ = fast_->info();
  info_.abilities.reactive_inputs = info_.abilities.chooses_step = false;
  info_.parameters = {};
  const auto add = [&](std::vector<Port>& to, const std::vector<Port>& ports, int from) {
    for (auto port = ports.begin() + from; port != ports.end(); ++port)
      to.push_back(*port), to.back().name = name_ + "." + port->name;
  };
  add(info_.inputs, more.inputs, links), add(info_.outputs, more.outputs, 0);
  for (const Feedthrough& f : fast_->info().feedthrough)
    for (int k = 0; k < links; ++k)
      if (links_[static_cast<std::size_t>(k)].displacement.port == f.input)
        info_.feedthrough.push_back({f.output, inputs + k});
  for (int k = 0; k < links; ++k) info_.feedthrough.push_back({fast_->info().output_size() + k, inputs + k});
}

/// Of displacements, and of velocities.
void ReactiveSide::add_answers() {
  using enum SurrogateLink::State;
  const auto add = [&](const ReactiveLink::End& end, std::size_t state) {
    const Segment offset{std::numeric_limits<double>::infinity(), 0.0, {end.offset}};
    answers_.push_back({end.port, offset, {&reaction_, static_cast<std::int32_t>(state), end.gain}});
  };
  for (std::size_t k = 0; k < links_.size(); ++k) {
    add(links_[k].displacement, k * SurrogateLink::states + at);
    if (links_[k].velocity) add(*links_[k].velocity, k * SurrogateLink::states + rate_of);
  }
}

std::vector<std::string> ReactiveSide::remarks(double t_stop) const {
  std::vector<std::string> all = fast_->remarks(t_stop);
  for (const std::string& one : surrogate_.remarks(t_stop)) all.push_back(name_ + ": " + one);
  return all;
}

Clock ReactiveSide::initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) {
  std::vector<double> of_fast(u0.begin(), u0.end()), of_surrogate(of_surrogate_.size());
  of_fast.resize(inputs());
  std::ranges::copy(u0.subspan(inputs()), of_surrogate.begin() + std::ssize(links_));
  surrogate_.end_at(t_stop), surrogate_.start(t_start, of_surrogate);
  surrogate_.describe(links_, terms_);
  for (const Answer& one : answers_)
    of_fast[static_cast<std::size_t>(one.input)] =
        Signal(&one.offset, 1, 0).with(&one.reactive).value(t_start, terms_.begin());
  tolerance_ = TimeTolerance(t_start);
  Samples rows = room_for(1, 0);
  clock_ = fast_->initialize(t_start, t_stop, of_fast, rows);
  read_forces(rows, 0);
  surrogate_.jump_to(t_start, forces_);
  put_row(rows, 0, y);
  return clock_;
}

/// Own steps after the next one, up to the first that reaches t.
std::int64_t ReactiveSide::steps_to(double t) const {
  const double far = t - clock_.next_time - tolerance_.width(t, clock_.next_time);
  const double steps = std::ceil(far / surrogate_.coupling().own_step);
  return static_cast<std::int64_t>(std::max(steps, 0.0));
}

/// Up to the first own step that reaches the slow side's next node.
double ReactiveSide::limit_for(double t_limit) const {
  const auto more = static_cast<double>(steps_to(surrogate_.node()));
  return std::min(t_limit, clock_.next_time + more * surrogate_.coupling().own_step);
}

bool ReactiveSide::can_step(double t_limit, bool land) const {
  return !tolerance_.before(t_limit, clock_.next_time) || (land && tolerance_.before(clock_.time, t_limit));
}

Clock ReactiveSide::advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) {
  set_inputs(u);
  const std::int64_t least = info_.abilities.events ? 2 : 1;
  while (y.room() >= least) {
    if (!can_step(t_limit, land)) return {clock_.time, clock_.next_time, Stop::limit};
    set_reaction();
    const double limit = limit_for(t_limit), before = clock_.time;
    Samples rows = room_for(std::min(y.room(), steps_to(limit) + least), terms_.states());
    clock_ = fast_->advance(limit, land && limit == t_limit, of_fast_, rows);
    take_rows(rows, before, y);
    const bool has_stopped = clock_.stop == Stop::event || clock_.stop == Stop::finished;
    if (has_stopped || rows.size() == 0) return clock_;
  }
  clock_.stop = Stop::samples_full;
  return clock_;
}

void ReactiveSide::set_inputs(std::span<const Signal> u) {
  std::ranges::copy(u.first(inputs()), of_fast_.begin());
  std::ranges::copy(u.subspan(inputs()), of_surrogate_.begin() + std::ssize(links_));
  for (const Answer& one : answers_)
    of_fast_[static_cast<std::size_t>(one.input)] = Signal(&one.offset, 1, 0).with(&one.reactive);
}

void ReactiveSide::set_reaction() {
  surrogate_.prepare(clock_.time, of_surrogate_);
  surrogate_.describe(links_, terms_);
  reaction_ = terms_.view();
}

/// For so many rows of the fast side, with states of the reaction behind each. What is not written there is not a number.
Samples ReactiveSide::room_for(std::int64_t rows, std::size_t states) {
  const std::int64_t stride = fast_->info().row_size() + static_cast<std::int64_t>(states);
  rows_.assign(static_cast<std::size_t>(rows * stride), std::numeric_limits<double>::quiet_NaN());
  return {rows_.data(), stride, rows};
}

void ReactiveSide::read_forces(const Samples& rows, std::int64_t row) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const ReactiveLink::End& end = links_[k].effort;
    forces_[k] = end.gain * rows.values(row)[static_cast<std::size_t>(end.port)] + end.offset;
  }
}

void ReactiveSide::take_rows(const Samples& rows, double before, Samples& y) {
  for (std::int64_t row = 0; row < rows.size(); ++row) {
    const double t = rows.time(row);
    read_forces(rows, row);
    const double* const z = rows.values(row).last(terms_.states()).data();
    if (t > before)
      surrogate_.follow({before, t, t - before}, forces_, z, of_surrogate_);
    else
      surrogate_.jump_to(t, forces_);
    put_row(rows, row, y);
    before = t;
  }
}

/// Block by block: outputs, then their derivatives.
void ReactiveSide::put_row(const Samples& rows, std::int64_t row, Samples& y) {
  surrogate_.outputs(surrogate_row_.data());
  const auto own =
      rows.values(row).first(static_cast<std::size_t>(fast_->info().row_size() - Samples::header));
  const std::size_t fast = outputs(), more = static_cast<std::size_t>(info_.output_size()) - fast;
  const auto put = [](std::span<const double> from, std::size_t block, std::size_t size, double* to) {
    const bool is_there = (block + 1) * size <= from.size();
    is_there ? std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(block * size), size, to)
             : std::fill_n(to, size, 0.0);
  };
  double* to = y.append(rows.time(row), rows.jump(row));
  for (std::size_t block = 0; block <= static_cast<std::size_t>(info_.derivatives()); ++block) {
    put(own, block, fast, to), to += fast;
    put(surrogate_row_, block, more, to), to += more;
  }
}

std::unique_ptr<Subsystem> reactive_side(std::unique_ptr<Subsystem> fast, ImpulseCoupling coupling,
                                         std::vector<ReactiveLink> links, const std::string& surrogate) {
  return std::make_unique<ReactiveSide>(std::move(fast), std::move(coupling), std::move(links), surrogate);
}

}  // namespace tandem
