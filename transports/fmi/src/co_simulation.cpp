// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "co_simulation.hpp"

#include <algorithm>
#include <utility>

#include "slave.hpp"
#include "tandem/fixed_step.hpp"
#include "tandem/saved_models.hpp"

namespace tandem::fmi {
namespace {

class CoSimulation final : public SavedModels<Slave, GridPlace> {
 public:
  explicit CoSimulation(Slave slave)
      : SavedModels<Slave, GridPlace>(std::move(slave)), jumps_(info_.input_size()) {}

  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    place_ = GridPlace(t_start, model_.own_step());
    model_.start({t_start, t_stop}, u0);
    append(y);
    return place_.clock();
  }

  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    jumps_.begin(u, place_.time());
    bool jumped = have_jumped(u);
    while (!model_.finished()) {
      if (y.room() <= (info_.abilities.events ? 1 : 0)) return place_.clock(Stop::samples_full);
      OwnStep s{place_.time(), place_.next(), place_.length()};
      if (!place_.fits(t_limit)) {
        if (!land || !place_.cuts(t_limit)) return place_.clock();
        s.end = t_limit, s.length = t_limit - s.begin;
      }
      jumped = pass_jumps(s) || jumped;
      const bool changed = model_.inputs_changed(s.begin, jumps_.inputs());
      if (happens(std::exchange(jumped, false) || changed || model_.is_due(s.begin), y)) return stop();
      if (model_.finished()) break;
      take(s, y);
      if (happens(model_.is_due(place_.time()), y)) return stop();
    }
    return place_.clock(Stop::finished);
  }

 private:
  bool have_jumped(std::span<const Signal> u) const {
    return std::any_of(u.begin(), u.end(), [this](const Signal& input) {
      return input.jumps_at(place_.time(), place_.tolerance());
    });
  }

  /// Whether there are any.
  bool pass_jumps(const OwnStep& s) {
    bool any = false;
    for (; jumps_.next() < s.end && !place_.tolerance().before(s.begin, jumps_.next()); any = true)
      jumps_.pass();
    return any;
  }

  /// An event where it stands, if one is due. True: outputs have jumped, and have a second row.
  bool happens(bool is_due, Samples& y) {
    if (!is_due || !info_.abilities.events || model_.finished()) return false;
    const bool jumped =
        model_.instance().within([&] { return model_.happen(place_.time(), jumps_.inputs()); });
    if (jumped) append(y, true);
    return jumped;
  }
  Clock stop() const { return place_.clock(model_.finished() ? Stop::finished : Stop::event); }

  void take(OwnStep s, Samples& y) {
    if (const double end = info_.abilities.lands ? model_.end_of(s) : s.end; end != s.end)
      s.end = end, s.length = end - s.begin;
    const double t = model_.instance().within([&] { return model_.step(s, jumps_.inputs()); });
    if (!place_.tolerance().before(s.begin, t)) return;
    place_.fits(t) ? place_.step() : place_.cut(t);
    append(y);
  }
  void append(Samples& y, bool jump = false) {
    double* const row = y.append(place_.time(), jump);
    model_.instance().within([&] { model_.outputs(row); });
  }

  Jumps jumps_;
};

}  // namespace

std::unique_ptr<Subsystem> make_co_simulation(std::shared_ptr<Instance> instance) {
  return std::make_unique<CoSimulation>(Slave(instance));
}

}  // namespace tandem::fmi
