// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/coupled.hpp"

namespace tandem::engine_linkage {

Coupled::Coupled(std::unique_ptr<Subsystem> linkage, std::unique_ptr<Subsystem> engine, const Scheme& scheme,
                 double stop, bool profile)
    : linkage_(std::move(linkage)), engine_(std::move(engine)) {
  topology_.add("linkage", linkage_->info());
  topology_.add("engine", engine_->info());
  topology_.connect({"linkage.speed", "engine.speed", Reconstruction::parse(scheme.to_fast)});
  topology_.connect({"engine.torque", "linkage.torque", Reconstruction::parse(scheme.to_slow)});
  topology_.set_start("linkage.torque", 0.0);
  topology_.check();
  Coordination coordination;
  coordination.schedule = Schedule::parse(scheme.schedule);
  coordination.order = {"linkage", "engine"};
  coordination.profile = profile;
  coordinator_ = std::make_unique<Coordinator>(topology_, std::vector{linkage_.get(), engine_.get()},
                                               coordination, TimeSpan{0.0, stop});
}

}  // namespace tandem::engine_linkage
