// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <span>
#include <utility>

#include "tandem/fixed_step_model.hpp"
#include "tandem/jumps.hpp"
#include "tandem/saved_models.hpp"

namespace tandem {

/// Makes a model with a fixed own step a Subsystem. It keeps the grid, takes the steps that fit, lands,
/// splits steps where an input jumps (Jumps), and appends samples. It adds the abilities `lands`, `restarts`
/// and `saves_state`. Model is copyable (a copy is its saved state) and has:
/// - `SubsystemInfo info() const`: ports, units, feedthrough.
/// - `double own_step() const`: h [s], finite and above 0.
/// - `void start(double t, std::span<const double> u0)`: puts the state at t; u0 may hold NaN.
/// - `void step(const OwnStep& s, std::span<const Signal> u)`: integrates over s, reads inputs anywhere in
///   it.
/// - `void outputs(double* y) const`: outputs, then derivatives, as the state is.
///
/// What it may have besides stands in fixed_step_model.hpp.
template <class Model>
class FixedStep final : public SavedModels<Model, GridPlace> {
  using Base = SavedModels<Model, GridPlace>;
  using Base::model_, Base::place_;

 public:
  explicit FixedStep(Model model) : Base(std::move(model)), jumps_(this->info_.input_size()) {
    this->info_.abilities.lands = true;
  }

  Clock initialize(double t_start, [[maybe_unused]] double t_stop, std::span<const double> u0,
                   Samples& y) override {
    place_ = GridPlace(t_start, model_.own_step());
    if constexpr (KnowsTheStop<Model>) model_.end_at(t_stop);
    model_.start(t_start, u0);
    model_.outputs(y.append(t_start));
    return place_.clock();
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    jumps_.begin(u, place_.time());
    if constexpr (Reacts<Model>) model_.react(reaction_of(u));
    if (!y.full() && have_jumped(u)) take_jump(y);
    while (has_room(y)) {
      if (is_finished()) return place_.clock(Stop::finished);
      OwnStep s{place_.time(), place_.next(), place_.length()};
      if (!place_.fits(t_limit)) {
        if (!land || !place_.cuts(t_limit)) return place_.clock();
        s.end = t_limit, s.length = t_limit - s.begin;
      }
      if (pass_jumps() && take_jump(y)) continue;
      if (integrate(s)) return stop_at(s.end, y);
      move_to(s.end);
      put_row(y);
    }
    return place_.clock(Stop::samples_full);
  }

 private:
  /// An event takes two rows.
  bool has_room(const Samples& y) const { return y.room() > (this->info_.abilities.events ? 1 : 0); }

  bool have_jumped(std::span<const Signal> u) const {
    if constexpr (!TakesJumps<Model>) return false;
    return std::any_of(u.begin(), u.end(), [this](const Signal& input) {
      return input.jumps_at(place_.time(), place_.tolerance());
    });
  }

  /// Inputs may also jump where a step of this call has ended: it goes on from there as a call that begins
  /// there does. False: none does.
  bool pass_jumps() {
    bool any = false;
    for (; jumps_.next() < place_.next() && !place_.tolerance().before(place_.time(), jumps_.next());
         any = true)
      jumps_.pass();
    return any;
  }

  /// A second row where it stands and inputs have jumped. False: no output has with them.
  bool take_jump(Samples& y) {
    if constexpr (TakesJumps<Model>)
      if (model_.jump(place_.time(), jumps_.inputs())) return put_row(y, true), true;
    return false;
  }

  void move_to(double t) { place_.fits(t) ? place_.step() : place_.cut(t); }

  /// The step, in parts from one jump of an input to the next. True: it has come to an event, at s.end.
  bool integrate(OwnStep& s) {
    const TimeTolerance& tolerance = place_.tolerance();
    while (jumps_.next() < s.end && tolerance.before(jumps_.next(), s.end)) {
      if (const double t = jumps_.next(); tolerance.before(s.begin, t)) {
        OwnStep part{s.begin, t, t - s.begin};
        if (step(part)) return s.end = part.end, true;
        s.begin = t, s.length = s.end - t;
      }
      jumps_.pass();
    }
    return step(s);
  }

  bool step(OwnStep& s) {
    if constexpr (HasEvents<Model>) return model_.step_to_event(s, jumps_.inputs());
    if constexpr (!HasEvents<Model>) model_.step(s, jumps_.inputs());
    return false;
  }

  /// A row as it was before the event, unless it stands there already, and one as it is now.
  Clock stop_at(double t, Samples& y) {
    if constexpr (HasEvents<Model>) {
      if (place_.tolerance().before(place_.time(), t)) {
        move_to(t);
        double* const row = y.append(place_.time());
        model_.outputs_before(row), put_reaction(row, y.stride());
      }
      put_row(y, true);
    }
    return place_.clock(is_finished() ? Stop::finished : Stop::event);
  }

  void put_row(Samples& y, bool jump = false) const {
    double* const row = y.append(place_.time(), jump);
    model_.outputs(row), put_reaction(row, y.stride());
  }
  /// At its end.
  void put_reaction([[maybe_unused]] double* row, [[maybe_unused]] std::int64_t stride) const {
    if constexpr (Reacts<Model>) {
      const std::span<const double> z = model_.reaction_states();
      std::copy(z.begin(), z.end(), row + stride - Samples::header - std::ssize(z));
    }
  }

  bool is_finished() const {
    if constexpr (MayFinish<Model>) return model_.finished();
    return false;
  }

  Jumps jumps_;
};

}  // namespace tandem
