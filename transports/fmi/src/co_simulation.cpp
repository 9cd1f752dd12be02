// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "co_simulation.hpp"

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
    while (!model_.finished()) {
      if (y.room() <= (info_.abilities.events ? 1 : 0)) return place_.clock(Stop::samples_full);
      OwnStep s{place_.time(), place_.next(), place_.length()};
      if (!place_.fits(t_limit)) {
        if (!land || !place_.cuts(t_limit)) return place_.clock();
        s.end = t_limit, s.length = t_limit - s.begin;
      }
      pass_jumps(s);
      if (happens(y, [&](double t) { return model_.inputs_changed(t, jumps_.inputs()); })) return stop();
      if (model_.finished()) break;
      take(s, y);
      if (happens(y, [&](double t) { return model_.is_due(t); })) return stop();
    }
    return place_.clock(Stop::finished);
  }

 private:
  void pass_jumps(const OwnStep& s) {
    while (jumps_.next() < s.end && !place_.tolerance().before(s.begin, jumps_.next())) jumps_.pass();
  }

  /// An event where it stands, if is_due(t) says so. True: outputs have jumped, and have a second row.
  template <class IsDue>
  bool happens(Samples& y, const IsDue& is_due) {
    if (!info_.abilities.events || model_.finished()) return false;
    const double t = place_.time();
    const bool jumped = model_.instance().within([&] { return is_due(t) && model_.happen(t); });
    if (jumped) append(y, true);
    return jumped;
  }
  Clock stop() const { return place_.clock(model_.finished() ? Stop::finished : Stop::event); }

  void take(OwnStep s, Samples& y) {
    if (const double event = model_.next_event(); info_.abilities.lands && event < s.end)
      s.end = event, s.length = event - s.begin;
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
