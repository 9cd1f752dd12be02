// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/indicators.hpp"

#include "indicator_parts.hpp"

namespace tandem {

Indicators::Indicators(const Coordinator& run, std::vector<PowerLink> links, std::vector<int> left_out)
    : parts_(std::make_unique<Parts>(run, links, left_out)) {}
Indicators::~Indicators() = default;

bool Indicators::samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) {
  parts_->begin(history.time(first));
  parts_->samples(subsystem, history, first, last);
  return true;
}
void Indicators::inputs(int subsystem, TimeSpan span, std::span<const Signal> lanes) {
  for (const Parts::Lane& lane : parts_->lanes_of(subsystem)) lane.defect->used.add(lanes[lane.slot], span);
}
void Indicators::inputs_at(int subsystem, double t, std::span<const double> lanes) {
  for (const Parts::Lane& lane : parts_->lanes_of(subsystem)) lane.defect->used.add(t, lanes[lane.slot]);
  parts_->acted(subsystem, t);
}
void Indicators::went_back(int subsystem, double t) {
  for (const Parts::Lane& lane : parts_->lanes_of(subsystem)) lane.defect->used.go_back(t);
}

const std::vector<Indicators::Connection>& Indicators::connections() const {
  parts_->settle_all();
  return parts_->connections();
}
const std::vector<Indicators::Link>& Indicators::links() const {
  parts_->settle_all();
  return parts_->links();
}
std::vector<double> Indicators::times() const { return parts_->times(); }
void Indicators::save(ByteWriter& to) const {
  parts_->settle_all();
  parts_->write(to);
}
void Indicators::resume(ByteReader& from) { parts_->read(from); }

}  // namespace tandem
