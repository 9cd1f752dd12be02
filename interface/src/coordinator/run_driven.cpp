// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that are known over the whole run: who ends own steps where they jump or bend.
#include <algorithm>
#include <iterator>

#include "feedthrough.hpp"
#include "run_start.hpp"

namespace tandem {
namespace {

/// Both ascend. False if there was nothing new.
bool unite(std::vector<double>& to, std::span<const double> more) {
  if (more.empty()) return false;
  std::vector<double> all;
  std::set_union(to.begin(), to.end(), more.begin(), more.end(), std::back_inserter(all));
  const bool any = all.size() > to.size();
  to = std::move(all);
  return any;
}

}  // namespace

template <class Visit>
void RunStart::each_driven(int who, const Visit& visit) const {
  for (int k = 0; k < topology_.info(who).input_size(); ++k)
    if (const TimeSeries* series = topology_.series(who, k)) visit(*series, k);
}

/// With inputs that are open, or known to jump.
bool RunStart::outputs_jump(int who) const {
  bool any = false;
  for (int k = 0; k < topology_.info(who).input_size(); ++k)
    any = any || (topology_.is_open(who, k) && !sampled(who) && feeds(topology_.info(who), k));
  each_driven(who, [&](const TimeSeries& series, int k) {
    any = any || (!series.jumps().empty() && !sampled(who) && feeds(topology_.info(who), k));
  });
  return any;
}

/// By subsystem when its inputs are known to jump, and its outputs with them. (Those of a sampled one change
/// at its instants.)
RunStart::KnownJumps RunStart::known_jumps() const {
  KnownJumps jumps{std::vector<std::vector<double>>(clocks_.size()), {}};
  jumps.of_outputs = jumps.of_inputs;
  const auto reach = [&](int who, int input, std::span<const double> times) {
    const auto i = static_cast<std::size_t>(who);
    const bool any = unite(jumps.of_inputs[i], times);
    return !sampled(who) && feeds(topology_.info(who), input) ? unite(jumps.of_outputs[i], times) || any
                                                              : any;
  };
  for (int i = 0; i < topology_.size(); ++i)
    each_driven(i, [&](const TimeSeries& series, int k) { reach(i, k, series.jumps()); });
  for (bool more = true; more;) {
    more = false;
    for (const Line& line : topology_.lines())
      if (line.lag == Lag::none)
        more =
            reach(line.reader, line.input, jumps.of_outputs[static_cast<std::size_t>(line.source)]) || more;
  }
  return jumps;
}

std::vector<double> RunStart::within_span(std::vector<double> times) const {
  std::erase_if(times, [this](double t) {
    return !run_.tolerance_.before(run_.t_start_, t) || !run_.tolerance_.before(t, run_.t_stop_);
  });
  return times;
}

/// To end a step at each: more than own steps, unless it is to land always.
bool RunStart::are_too_many(int who, const std::vector<double>& times) const {
  const double shortest = times_.shortest_period[static_cast<std::size_t>(who)];
  return !times.empty() && static_cast<double>(times.size()) * shortest > run_.t_stop_ - run_.t_start_;
}

/// Where one that integrates itself ends steps: at jumps and kinks, or at jumps alone where the kinks are too
/// many.
std::vector<double> RunStart::breaks_of(int who, const std::vector<double>& known) const {
  const std::vector<double> jumps = within_span(known);
  std::vector<double> all = jumps;
  each_driven(who, [&](const TimeSeries& series, int) { unite(all, series.kinks()); });
  if (all = within_span(std::move(all)); !are_too_many(who, all)) return all;
  if (!are_too_many(who, jumps)) return jumps;
  note_missed(who, "jumps that its inputs are known to have");
  return {};
}

void RunStart::note_driven() {
  const KnownJumps jumps = known_jumps();
  for (int i = 0; i < topology_.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    times_.breaks.push_back(sampled(i) ? std::vector<double>() : breaks_of(i, jumps.of_inputs[k]));
    has_breaks_ = has_breaks_ || !times_.breaks[k].empty();
    if (!times_.breaks[k].empty() || !jumps.of_outputs[k].empty()) times_.nearest[k] = nearest_node(i);
    unite(rounds_end_at_, jumps.of_outputs[k]);
  }
}

}  // namespace tandem
