// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "coupling_indicator.hpp"

namespace tandem {
namespace {

/// Power that the coupling makes (see Indicators), and that passes, at the time looked at last.
struct Power {
  double made, passed;
};

Power power(PowerLink::Kind kind, double ratio, const LineDefect& e, const LineDefect& f,
            const OutputTrack& of_e, const OutputTrack& of_f) {
  if (kind == PowerLink::Kind::flow)
    return {e.defect * f.output - ratio * e.output * f.defect, e.gain() * e.output * f.output};
  const double f_rate = of_f.rate(f.column());
  const double made = e.defect * f_rate + ratio * f.defect * of_e.rate(e.column());
  const bool spring = kind == PowerLink::Kind::stiffness;
  return {made, (spring ? e.output - f.output : e.gain() * e.output) * f_rate};
}

/// The first row at or past t, from `row` on. Precondition: there is one.
std::int64_t row_at(const OutputTrack& track, std::int64_t row, double t) {
  while (row < track.newest() && track.time(row) < t) ++row;
  return std::min(row, track.newest());
}

void check_row(std::int64_t row, const OutputTrack& of, const ByteReader& from) {
  const bool there = of.newest() < 1 || of.has(std::min(row, of.newest()) - 1);
  if (row < 1 || row > of.newest() + 1 || !there)
    from.refuse("has an indicator that stands at row " + std::to_string(row) +
                " of outputs that end at row " + std::to_string(of.newest()));
}

}  // namespace

void CouplingIndicator::add(Indicators::Link& told, LineDefect& effort, LineDefect& back,
                            int source_of_effort) {
  links_.push_back({&told, &effort, &back, source_of_effort == fine_, effort.gain() / back.gain()});
}

/// Beyond the end of one of them nothing of the other is looked at.
void CouplingIndicator::settle(const TrackEnd& fine, const TrackEnd& coarse, const Windows& windows) {
  settle(fine.track, coarse.track, windows);
  if (coarse.ended) next_ = std::max(next_, fine.track.newest() + 1);
  if (fine.ended && next_ > fine.track.newest()) row_ = std::max(row_, coarse.track.newest());
}

void CouplingIndicator::settle(OutputTrack& fine, OutputTrack& coarse, const Windows& windows) {
  if (coarse.newest() < 1) return;
  for (; next_ <= fine.newest(); ++next_) {
    const double a = fine.time(next_ - 1), length = fine.time(next_) - a, t = a + 0.5 * length;
    if (!(t <= coarse.newest_time())) return;
    if (fine.begins(next_)) continue;
    row_ = row_at(coarse, row_, t);
    if (coarse.begins(row_)) continue;
    fine.look(next_, t);
    coarse.look(row_, t);
    look(fine, coarse, t, length, windows.at(t));
  }
}

void CouplingIndicator::look(const OutputTrack& fine, const OutputTrack& coarse, double t, double length,
                             std::size_t window) {
  for (LineDefect* line : of_fine_) line->look(fine, t, window);
  for (LineDefect* line : of_coarse_) line->look(coarse, t, window);
  for (const Link& link : links_) {
    const auto& of_effort = link.effort_is_fine ? fine : coarse;
    const auto& of_back = link.effort_is_fine ? coarse : fine;
    const Power p = power(link.told->link.kind, link.ratio, *link.effort, *link.back, of_effort, of_back);
    if (std::isnan(p.made)) continue;
    const double energy = link.told->link.scale * length;
    link.told->windows[window] += energy * p.made;
    link.told->energy += energy * p.made;
    link.told->passed += std::abs(energy * p.passed);
  }
}

void CouplingIndicator::write(ByteWriter& to) const {
  to.put(next_);
  to.put(row_);
}

void CouplingIndicator::read(ByteReader& from, const OutputTrack& fine, const OutputTrack& coarse) {
  check_row(next_ = from.take<std::int64_t>(), fine, from);
  check_row(row_ = from.take<std::int64_t>(), coarse, from);
}

void SamplingIndicator::settle(OutputTrack& source, bool reader_ended, const Windows& windows) {
  for (; looked_at_ < instants_.size(); ++looked_at_) {
    const double t = instants_[looked_at_];
    if (source.newest() < 1 || !(t <= source.newest_time())) break;
    row_ = row_at(source, row_, t);
    const bool jumps =
        source.begins(row_) || (row_ < source.newest() && source.begins(row_ + 1) && source.time(row_) == t);
    if (jumps) continue;
    source.look(row_, t);
    for (LineDefect* line : lines_) line->look(source, t, windows.at(t));
  }
  if (reader_ended && looked_at_ == instants_.size()) row_ = std::max(row_, source.newest());
  constexpr std::size_t few = 64;
  if (looked_at_ < few || 2 * looked_at_ < instants_.size()) return;
  instants_.erase(instants_.begin(), instants_.begin() + static_cast<std::ptrdiff_t>(looked_at_));
  looked_at_ = 0;
}

void SamplingIndicator::write(ByteWriter& to) const {
  to.put(row_);
  to.put_list(std::span(instants_).subspan(looked_at_));
}

void SamplingIndicator::read(ByteReader& from, const OutputTrack& source) {
  check_row(row_ = from.take<std::int64_t>(), source, from);
  instants_ = from.take_list(), looked_at_ = 0;
  if (!std::all_of(instants_.begin(), instants_.end(), [](double t) { return std::isfinite(t); }))
    from.refuse("has instants of a sampled subsystem that are not finite");
}

}  // namespace tandem
