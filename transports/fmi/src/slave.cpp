// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "slave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "over_step.hpp"
#include "tandem/error.hpp"

namespace tandem::fmi {

namespace {
constexpr double never = std::numeric_limits<double>::infinity();
}

Slave::Slave(const std::shared_ptr<Instance>& instance)
    : running_(instance),
      values_(static_cast<std::size_t>(info().input_size())),
      before_(static_cast<std::size_t>(info().row_size() - Samples::header)),
      after_(before_),
      next_event_(never),
      stop_(never) {
  const Settings& settings = instance->fmu().settings;
  if (settings.held != Held::derivatives) return;
  for (int order = 1; order <= settings.order; ++order)
    for (const Seat& seat : instance->fmu().ports.continuous) {
      references_.push_back(instance->fmu().description.at(seat.variable).reference);
      orders_.push_back(order);
    }
  derivatives_.resize(references_.size());
}

void Slave::start(const TimeSpan& span, std::span<const double> u0) {
  finished_ = due_ = false, next_event_ = never, standing_ = 0;
  const bool ends = std::isfinite(span.stop);
  stop_ = ends ? span.stop : never;
  put_start(info().inputs, u0, values_);
  instance().within([&] {
    running_.initialize(span.start, ends ? std::optional(span.stop) : std::nullopt, u0);
    if (has_events()) settle(span.start);
    if (!finished_) running_.try_derivatives();
  });
}

/// From event mode, or the end of initialization, to steps.
void Slave::settle(double t) {
  const Updated updated = running_.settle(t);
  finished_ = finished_ || updated.ended;
  next_event_ = updated.next_event;
  due_ = false;
  if (!finished_) instance().enter_steps();
}

double Slave::end_of(const OwnStep& s) const {
  const TimeTolerance tolerance(s.begin);
  const bool within = std::isfinite(next_event_) && tolerance.before(s.begin, next_event_) &&
                      !tolerance.before(s.end, next_event_);
  return within ? std::min(next_event_, std::max(stop_, s.end)) : s.end;
}

bool Slave::happen(double t, std::span<const Signal> u) {
  running_.resume();
  running_.know_inputs();
  running_.read_row(before_.data());
  instance().enter_events();
  for (const auto* seats : {&running_.fmu().ports.continuous, &running_.fmu().ports.discrete})
    take(*seats, u, t, values_);
  running_.set_continuous(values_.data(), t);
  running_.set_discrete(values_.data(), t);
  settle(t);
  running_.read_row(after_.data());
  return after_ != before_;
}

double Slave::over(const OwnStep& s, const Signal& u) const {
  switch (running_.fmu().settings.held) {
    case Held::mean:
    case Held::intermediate:  // of those that the FMU does not ask for
      return mean_over(u, s);
    case Held::right:
      return u.value(s.end);
    case Held::middle:
      return u.value(s.begin + 0.5 * s.length);
    default:
      return u.value(s.begin);
  }
}

void Slave::set_inputs(const OwnStep& s, std::span<const Signal> u) {
  const Ports& ports = running_.fmu().ports;
  for (const Seat& seat : ports.continuous)
    for (int k = seat.place; k < seat.end(); ++k)
      values_[static_cast<std::size_t>(k)] = over(s, u[static_cast<std::size_t>(k)]);
  if (running_.fmu().settings.held == Held::intermediate) take(ports.asked, u, s.begin, values_);
  running_.set_continuous(values_.data(), s.begin);
  if (has_events()) return;
  take(ports.discrete, u, s.begin, values_);
  running_.set_discrete(values_.data(), s.begin);
  if (!references_.empty()) set_derivatives(s, u);
}

void Slave::set_derivatives(const OwnStep& s, std::span<const Signal> u) {
  std::size_t k = 0;
  for (int order = 1; order <= running_.fmu().settings.order; ++order)
    for (const Seat& seat : running_.fmu().ports.continuous) {
      const Signal signal = from_begin(u[static_cast<std::size_t>(seat.place)], s);
      derivatives_[k++] = order == 1 ? signal.derivative(s.begin) : signal.second_derivative(s.begin);
    }
  instance().set_input_derivatives(references_, orders_, derivatives_);
}

double Slave::step(const OwnStep& s, std::span<const Signal> u) {
  struct Within final : InputsWithin {
    void set(double t) override {
      take(of->running_.fmu().ports.asked, u, t, of->values_);
      of->running_.set_asked(of->values_.data(), t);
    }
    Slave* of;
    std::span<const Signal> u;
  } within;
  within.of = this, within.u = u;
  running_.resume();
  running_.know_inputs();
  set_inputs(s, u);
  const Taken taken = instance().do_step(s, !keeps_state(), within);
  due_ = taken.event, finished_ = taken.ended;
  check_progress(s, taken);
  if (!running_.has_followed() || finished_) return taken.time;
  take(running_.fmu().ports.followed, u, taken.time, values_);
  running_.set_followed(values_.data(), taken.time);
  return taken.time;
}

void Slave::check_progress(const OwnStep& s, const Taken& taken) {
  constexpr int most = 100;
  standing_ = TimeTolerance(s.begin).before(s.begin, taken.time) || taken.ended ? 0 : standing_ + 1;
  if (standing_ > most)
    throw Error(
        ErrorCode::numerical,
        fmt::format("the FMU has returned {} times from a step at {} s without going on", most, s.begin));
}

void Slave::write(ByteWriter& to) const {
  running_.write(to);
  to.put_list(values_);
  to.put(next_event_);
  to.put(std::uint8_t{due_});
  to.put(std::uint8_t{finished_});
}

void Slave::read(ByteReader& from) {
  running_.read(from);
  from.take_list(values_);
  next_event_ = from.take<double>();
  due_ = from.take<std::uint8_t>() != 0;
  finished_ = from.take<std::uint8_t>() != 0;
}

}  // namespace tandem::fmi
