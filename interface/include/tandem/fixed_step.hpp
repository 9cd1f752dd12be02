// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/error.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem {

/// One own step from `begin` to `end` [s]; length is h, or less where a step is cut.
struct OwnStep {
  double begin, end, length;
};

/// A model that gives its state as bytes.
template <class Model>
concept WritesState = requires(const Model& model, Model& other, ByteWriter& to, ByteReader& from) {
  model.write(to);
  other.read(from);
};

/// Makes a model with a fixed own step a Subsystem: keeps the grid, takes the steps that fit, lands, appends
/// samples; adds the abilities `lands`, `restarts` and `saves_state`. Model is copyable (a copy is its saved
/// state) and has:
/// @code
/// SubsystemInfo info() const;                              // ports, units, feedthrough
/// double own_step() const;                                 // h [s], finite and above 0
/// void start(double t, std::span<const double> u0);        // puts the state at t; u0 may hold NaN
/// void step(const OwnStep& s, std::span<const Signal> u);  // integrates over s, reads inputs anywhere in it
/// void outputs(double* y) const;                           // outputs, then derivatives, as the state is
/// @endcode
/// With the ability `serializes_state` in its info() it also has
/// @code
/// void write(ByteWriter& to) const;  // all that its steps go by and that start() does not make
/// void read(ByteReader& from);       // the same of a model that is made and started alike; refuses
/// another's
/// @endcode
template <class Model>
class FixedStep final : public Subsystem {
 public:
  explicit FixedStep(Model model) : model_(std::move(model)), info_(model_.info()) {
    info_.abilities.lands = info_.abilities.restarts = info_.abilities.saves_state = true;
  }

  const SubsystemInfo& info() const override { return info_; }
  const Model& model() const { return model_; }

  Clock initialize(double t_start, double /*t_stop*/, std::span<const double> u0, Samples& y) override {
    grid_ = TimeGrid(t_start, model_.own_step());
    model_.start(t_start, u0);
    model_.outputs(y.append(t_start));
    return clock(Stop::limit);
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    for (; !y.full(); model_.outputs(y.append(grid_.time()))) {
      if (grid_.fits(t_limit)) {
        model_.step({grid_.time(), grid_.next(), grid_.length()}, u);
        grid_.step();
      } else if (land && grid_.cuts(t_limit)) {
        model_.step({grid_.time(), t_limit, t_limit - grid_.time()}, u);
        grid_.cut(t_limit);
      } else {
        return clock(Stop::limit);
      }
    }
    return clock(Stop::samples_full);
  }

  StateId save_state() override {
    saved_.emplace_back(++last_id_, std::pair{model_, grid_});
    return last_id_;
  }
  Clock restore_state(StateId id) override {
    std::tie(model_, grid_) = saved(id)->second;
    return clock(Stop::limit);
  }
  void release_state(StateId id) override { saved_.erase(saved(id)); }

  std::vector<std::byte> serialize_state(StateId id) override {
    if constexpr (WritesState<Model>)
      if (info_.abilities.serializes_state) {
        ByteWriter to;
        saved(id)->second.second.write(to);
        saved(id)->second.first.write(to);
        return {to.bytes().begin(), to.bytes().end()};
      }
    return Subsystem::serialize_state(id);
  }
  StateId deserialize_state(std::span<const std::byte> bytes) override {
    if constexpr (WritesState<Model>)
      if (info_.abilities.serializes_state) {
        ByteReader from(bytes, info_.name, "state of");
        std::pair state{model_, grid_};
        state.second.read(from);
        state.first.read(from);
        from.end();
        saved_.emplace_back(++last_id_, std::move(state));
        return last_id_;
      }
    return Subsystem::deserialize_state(bytes);
  }

 private:
  using Saved = std::vector<std::pair<StateId, std::pair<Model, TimeGrid>>>;

  Clock clock(Stop stop) const { return {grid_.time(), grid_.next(), stop}; }
  typename Saved::iterator saved(StateId id) {
    const auto it =
        std::find_if(saved_.begin(), saved_.end(), [id](const auto& entry) { return entry.first == id; });
    if (it != saved_.end()) return it;
    throw Error(ErrorCode::invalid_argument,
                "subsystem '" + info_.name + "' has no saved state " + std::to_string(id));
  }

  Model model_;
  SubsystemInfo info_;
  TimeGrid grid_;
  StateId last_id_ = 0;
  Saved saved_;
};

}  // namespace tandem
