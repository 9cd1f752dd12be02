// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::test {

using Wrap = std::function<std::unique_ptr<Subsystem>(std::unique_ptr<Subsystem>)>;

/// Passes everything on but the saving of states.
class Adapter : public Subsystem {
 public:
  explicit Adapter(std::unique_ptr<Subsystem> inner) : inner_(std::move(inner)), info_(inner_->info()) {
    info_.abilities.saves_state = info_.abilities.serializes_state = false;
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    return inner_->initialize(t_start, t_stop, u0, y);
  }

 protected:
  std::unique_ptr<Subsystem> inner_;

 private:
  SubsystemInfo info_;
};

/// Takes one own step a call and returns early, as at an event.
class OneStepACall final : public Adapter {
 public:
  using Adapter::Adapter;
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    tolerance_ = TimeTolerance(t_start);
    return clock_ = inner_->initialize(t_start, t_stop, u0, y);
  }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    const bool fits = !tolerance_.before(t_limit, clock_.next_time);
    clock_ = fits ? inner_->advance(clock_.next_time, false, u, y) : inner_->advance(t_limit, land, u, y);
    const bool more =
        !tolerance_.before(t_limit, clock_.next_time) || (land && tolerance_.before(clock_.time, t_limit));
    if (more && clock_.stop == Stop::limit) clock_.stop = Stop::event;
    return clock_;
  }

 private:
  TimeTolerance tolerance_;
  Clock clock_{};
};

/// Has room for three samples a call, whatever the caller has.
class ThreeSamplesACall final : public Adapter {
 public:
  using Adapter::Adapter;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    const tandem_samples all = y.c_view();
    Samples few(all.rows, all.stride, std::min(all.capacity, all.size + 3), all.size);
    const Clock clock = inner_->advance(t_limit, land, u, few);
    y.set_size(few.size());
    return clock;
  }
};

/// Compares times strictly: a node an ulp past the limit is not taken.
class Strict final : public Adapter {
 public:
  using Adapter::Adapter;
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    return clock_ = inner_->initialize(t_start, t_stop, u0, y);
  }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    while (!y.full() && clock_.next_time <= t_limit) clock_ = inner_->advance(clock_.next_time, false, u, y);
    if (land && !y.full() && clock_.time < t_limit) clock_ = inner_->advance(t_limit, true, u, y);
    return clock_;
  }

 private:
  Clock clock_{};
};

/// Sees no marks of jumps, so that it goes over them in one step.
class OverJumps final : public Adapter {
 public:
  using Adapter::Adapter;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    pieces_.clear();
    for (const Signal& signal : u) {
      const auto segments = signal.segments();
      pieces_.emplace_back(segments.begin(), segments.end());
      for (Segment& s : pieces_.back()) mark_jump(s, false);
    }
    signals_.clear();
    for (std::size_t k = 0; k < u.size(); ++k)
      signals_.emplace_back(pieces_[k].data(), static_cast<std::int32_t>(pieces_[k].size()), u[k].degree());
    return inner_->advance(t_limit, land, signals_, y);
  }

 private:
  std::vector<std::vector<Segment>> pieces_;
  std::vector<Signal> signals_;
};

/// As it is, but each call takes some microseconds more.
class Busy final : public Adapter {
 public:
  using Adapter::Adapter;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(5);
    while (std::chrono::steady_clock::now() < until) {
    }
    return inner_->advance(t_limit, land, u, y);
  }
};

inline std::unique_ptr<Subsystem> as_it_is(std::unique_ptr<Subsystem> s) { return s; }
inline std::unique_ptr<Subsystem> one_step_a_call(std::unique_ptr<Subsystem> s) {
  return std::make_unique<OneStepACall>(std::move(s));
}
inline std::unique_ptr<Subsystem> three_samples_a_call(std::unique_ptr<Subsystem> s) {
  return std::make_unique<ThreeSamplesACall>(std::move(s));
}
inline std::unique_ptr<Subsystem> over_jumps(std::unique_ptr<Subsystem> s) {
  return std::make_unique<OverJumps>(std::move(s));
}
inline std::unique_ptr<Subsystem> busy(std::unique_ptr<Subsystem> s) {
  return std::make_unique<Busy>(std::move(s));
}
inline std::unique_ptr<Subsystem> strict(std::unique_ptr<Subsystem> s) {
  return std::make_unique<Strict>(std::move(s));
}

}  // namespace tandem::test
