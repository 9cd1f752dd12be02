// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/experiment.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "kart/player.hpp"
#include "output/on_grid.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/error.hpp"

namespace tandem::kart {
namespace {

std::unique_ptr<Subsystem> open_kart(const Scene& scene, const Kart& kart) {
  const bool formulas = kart.level == "point" || kart.level == "plane";
  Opening opening{{}, scene.folder};
  opening.parameters.set("step", kart.step());
  if (!formulas) opening.parameters.set("tolerance", 1e-7);
  if (kart.level.starts_with("spatial")) opening.parameters.set("carry_multipliers", true);
  if (kart.level == "spatial_scalar_spin") opening.parameters.set("beta", 1.0 / 12.0);
  return open(formulas ? "builtin:kart." + kart.level : "mechanism:" + kart.level + ".toml", scene.builtins,
              std::move(opening));
}

std::unique_ptr<Subsystem> open_engine(const Scene& scene) {
  Opening opening{{}, scene.folder};
  opening.parameters.set("step", engine_step);
  opening.parameters.set("engine", std::string("engine_compiled.toml"));
  opening.parameters.set("gearbox", std::string("kart_automatic_compiled.toml"));
  return open("diagram:../engine/kart_power_train.toml", scene.builtins, std::move(opening));
}

int output(const Subsystem& subsystem, const std::string& name) {
  const auto& all = subsystem.info().outputs;
  const auto it = std::find_if(all.begin(), all.end(), [&](const Port& p) { return p.name == name; });
  if (it == all.end())
    throw Error(ErrorCode::invalid_argument,
                "subsystem '" + subsystem.info().name + "' has no output " + name);
  return static_cast<int>(it - all.begin());
}

/// Keeps the pitch of the kart, which is the first, and the torque of the other, at nodes of their own steps.
class Keep final : public Observer {
 public:
  Keep(const Subsystem& kart, const Subsystem& other, double kart_step, Course& course)
      : columns_{output(kart, "pitch"), output(other, "torque")},
        steps_{kart_step, engine_step},
        course_(course) {
    course_.trace = Trace(kart.info(), other.info());
  }
  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    const int column = columns_[subsystem];
    for (std::int64_t k = first; k <= last; ++k) {
      if (!on_grid(history, k, steps_[subsystem])) continue;
      const double value = history.values(k)[column];
      if (subsystem == 0)
        course_.pitch.push_back(value * degrees);
      else
        course_.torque.push_back(value);
      course_.trace.add(subsystem, history, k);
    }
    return true;
  }

 private:
  int columns_[2];
  double steps_[2];
  Course& course_;
};

/// Two subsystems, the kart first, through the manoeuvre.
Course run(Topology& topology, Subsystem& kart, Subsystem& other, double kart_step,
           const std::string& schedule, bool profile) {
  topology.set_start("kart.torque", 0.0);
  topology.check();
  Coordination coordination;
  coordination.schedule = Schedule::parse(schedule);
  coordination.order = {"kart", "engine"};
  coordination.profile = profile;
  Coordinator coordinator(topology, {&kart, &other}, coordination, TimeSpan{0.0, t_stop});
  Course course;
  Keep keep(kart, other, kart_step, course);
  coordinator.observe(&keep);
  coordinator.initialize();
  const double starts[] = {coordinator.effort(0).seconds, coordinator.effort(1).seconds};
  const auto began = std::chrono::steady_clock::now();
  try {
    while (coordinator.round()) {
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    course.failure = error.what();
  }
  course.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  course.kart_share = (coordinator.effort(0).seconds - starts[0]) / course.seconds;
  course.engine_share = (coordinator.effort(1).seconds - starts[1]) / course.seconds;
  course.coordinator_share = 1.0 - course.kart_share - course.engine_share;
  return course;
}

}  // namespace

Course couple(const Scene& scene, const Kart& kart, const Scheme& scheme, bool profile) {
  const auto vehicle = open_kart(scene, kart), engine = open_engine(scene);
  Topology topology;
  topology.add("kart", vehicle->info());
  topology.add("engine", engine->info());
  topology.connect({"kart.shaft_speed", "engine.shaft", Reconstruction::parse(scheme.to_fast)});
  topology.connect({"kart.speed", "engine.speed", Reconstruction::parse(scheme.to_fast)});
  topology.connect({"engine.torque", "kart.torque", Reconstruction::parse(scheme.to_slow)});
  return run(topology, *vehicle, *engine, kart.step(), scheme.schedule, profile);
}

Course replay(const Scene& scene, const Kart& kart, const std::vector<double>& torque, bool mean) {
  const auto vehicle = open_kart(scene, kart), player = make_player(torque, engine_step);
  Topology topology;
  topology.add("kart", vehicle->info());
  topology.add("engine", player->info());
  topology.connect({"engine.torque", "kart.torque", Reconstruction::parse(mean ? "mean" : "lagrange1")});
  return run(topology, *vehicle, *player, kart.step(), "fastest-first", false);
}

Difference difference(const Course& course, const Course& finer) {
  const std::size_t ratio = (finer.pitch.size() - 1) / std::max<std::size_t>(1, course.pitch.size() - 1);
  Difference d;
  for (std::size_t k = 0; k < course.pitch.size(); ++k) {
    const double off = std::abs(course.pitch[k] - finer.pitch[k * ratio]);
    d.largest = off <= d.largest ? d.largest : off;
    d.rms += off * off;
  }
  d.rms = std::sqrt(d.rms / static_cast<double>(course.pitch.size()));
  return d;
}

}  // namespace tandem::kart
