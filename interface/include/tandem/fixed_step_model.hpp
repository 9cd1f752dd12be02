// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <concepts>
#include <span>

#include "tandem/signal.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

/// What a model for FixedStep (fixed_step.hpp) may have besides what it has to have: for events, jumps, ends and reactions by
/// the concepts below, and these.
///
/// A model that can't be copied once it has started has `bool keeps_state() const`: whether it has the ability
/// `saves_state`.
///
/// A model that gives its states as numbers (Subsystem::states) has:
/// - `std::optional<std::vector<StateName>> states() const`, `void get_states(std::span<double> x) const` and
///   `void set_states(std::span<const double> x)`.
///
/// One that gives its equations has `std::shared_ptr<SlowModel> slow_model(std::span<const SlowLink> links) const`.
///
/// With the ability `serializes_state` in its info() it also has:
/// - `void write(ByteWriter& to) const`: all that its steps go by and that start() does not make.
/// - `void read(ByteReader& from)`: the same of a model that is made and started alike; refuses another's.
namespace tandem {

/// One own step from `begin` to `end` [s]; length is h, or less where a step is cut.
struct OwnStep {
  double begin, end, length;
};

/// A TimeGrid as the place of a subsystem.
struct GridPlace : TimeGrid {
  using TimeGrid::TimeGrid;
  Clock clock(Stop stop = Stop::limit) const { return {time(), next(), stop}; }
};

/// A model whose outputs jump at events, with the ability `events` in its info(). In place of step() it has:
/// - `bool step_to_event(OwnStep& s, std::span<const Signal> u)`: true: outputs jump at an event, to which it
///   came, and s.end is its time.
/// - `void outputs_before(double* y) const`: as they were just before that.
template <class Model>
concept HasEvents =
    requires(Model& model, const Model& same, OwnStep& s, std::span<const Signal> u, double* y) {
      { model.step_to_event(s, u) } -> std::same_as<bool>;
      same.outputs_before(y);
    };

/// A model of which an output follows inputs at once.
/// - `bool jump(double t, std::span<const Signal> u)`: inputs have jumped at t, where it stands; true:
///   outputs have with them.
template <class Model>
concept TakesJumps = requires(Model& model, double t, std::span<const Signal> u) {
  { model.jump(t, u) } -> std::same_as<bool>;
};

/// A model with the ability `reactive_inputs` in its info(): it integrates the states of a reaction (reaction.h) along with
/// its own.
/// - `void react(const Reaction* reaction)`: before the first step of a call; null: no input reacts. It has the states
///   at the begin, and is valid during the call.
/// - `std::span<const double> reaction_states() const`: those where the model stands.
template <class Model>
concept Reacts = requires(Model& model, const Model& same, const Reaction* reaction) {
  model.react(reaction);
  { same.reaction_states() } -> std::convertible_to<std::span<const double>>;
};

/// A model that may come to an end of its own, after which it takes no more steps.
/// - `bool finished() const`: after a step or an event, it has come to its end.
template <class Model>
concept MayFinish = requires(const Model& model) {
  { model.finished() } -> std::same_as<bool>;
};

/// A model that goes by where a run ends.
/// - `void end_at(double t_stop)`: before start() [s]; infinite if that is not known.
template <class Model>
concept KnowsTheStop = requires(Model& model, double t_stop) { model.end_at(t_stop); };

}  // namespace tandem
