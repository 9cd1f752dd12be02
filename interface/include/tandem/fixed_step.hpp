// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <utility>

#include "tandem/saved_models.hpp"
#include "tandem/time_grid.hpp"

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
class FixedStep final : public SavedModels<Model, GridPlace> {
  using Base = SavedModels<Model, GridPlace>;
  using Base::model_, Base::place_;

 public:
  explicit FixedStep(Model model) : Base(std::move(model)) { this->info_.abilities.lands = true; }

  Clock initialize(double t_start, double /*t_stop*/, std::span<const double> u0, Samples& y) override {
    place_ = GridPlace(t_start, model_.own_step());
    model_.start(t_start, u0);
    model_.outputs(y.append(t_start));
    return place_.clock();
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    for (; !y.full(); model_.outputs(y.append(place_.time()))) {
      if (place_.fits(t_limit)) {
        model_.step({place_.time(), place_.next(), place_.length()}, u);
        place_.step();
      } else if (land && place_.cuts(t_limit)) {
        model_.step({place_.time(), t_limit, t_limit - place_.time()}, u);
        place_.cut(t_limit);
      } else {
        return place_.clock();
      }
    }
    return place_.clock(Stop::samples_full);
  }
};

}  // namespace tandem
