// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What sampled subsystems need before a run.
#include <algorithm>
#include <limits>

#include "run_start.hpp"
#include "tandem/coordinator/components.hpp"

namespace tandem {

void RunStart::note_times(double communication_step) {
  times_.memory = run_.own_steps_;
  times_.delay = communication_step;
  std::vector<std::pair<int, int>> edges;
  for (const Line& line : topology_.lines()) edges.emplace_back(line.source, line.reader);
  for (int i = 0; i < topology_.size(); ++i) times_.shortest_period.push_back(shortest_period(i));
  times_.loop = strongly_connected(topology_.size(), edges);
  times_.nearest.assign(run_.own_steps_.size(), 0.0);
  for (const Line& line : topology_.lines())
    for (const int who : {line.source, line.reader})
      if (!sampled(who) && lands(line) && !topology_.info(who).abilities.chooses_step)
        times_.nearest[static_cast<std::size_t>(who)] = nearest_node(who);
  for (const Line& line : topology_.lines())
    if (topology_.info(line.source).abilities.events)
      for (const int who : {line.source, line.reader})
        if (!sampled(who)) times_.nearest[static_cast<std::size_t>(who)] = nearest_node(who);
  for (int i = 0; i < topology_.size() && run_.coordination_.pauses; ++i)
    if (!sampled(i)) times_.nearest[static_cast<std::size_t>(i)] = nearest_node(i);
}

/// Of one with samples beside its own nodes. Half a step apart is near enough, however times are rounded.
double RunStart::nearest_node(int who) const {
  return topology_.info(who).abilities.chooses_step ? std::numeric_limits<double>::min()
                                                    : run_.own_step(who) / 2.0 - rounding();
}

/// [s]: of a memory or delay.
double RunStart::lag_of(const Line& line) const {
  if (line.lag == Lag::memory) return run_.own_step(line.reader);
  return line.lag == Lag::delay ? times_.delay : 0.0;
}

std::vector<Read> RunStart::reads() const {
  std::vector<Read> all;
  for (const Line& line : topology_.lines()) {
    const bool just_before = topology_.just_before(line);
    const double lag = topology_.info(line.source).sampling.latency + (just_before ? 0.0 : lag_of(line));
    all.push_back({line.reader, line.source, lag, just_before, lands(line),
                   topology_.info(line.reader).sampling.period});
  }
  add_watched(all);
  add_sources_behind(all);
  return all;
}

/// Which sampled subsystems act together, and in which order they give their outputs then.
void RunStart::note_samples(const std::vector<Read>& reads) {
  const auto size = static_cast<std::size_t>(topology_.size());
  std::size_t most = 0;
  for (int i = 0; i < topology_.size(); ++i) {
    run_.has_samples_ = run_.has_samples_ || sampled(i);
    if (sampled(i)) most = std::max(most, static_cast<std::size_t>(topology_.info(i).output_size()));
  }
  run_.outputs_.assign(most, 0.0);
  run_.together_.assign(size, 0);
  run_.acts_.assign(size, 0);
  run_.acting_.reserve(size);
  run_.going_.reserve(size);
  std::vector<std::pair<int, int>> edges;
  for (const Read& r : reads)
    if (sampled(r.reader) && sampled(r.source) && r.lag == 0.0 && !r.just_before && r.reader != r.source)
      edges.emplace_back(r.source, r.reader);
  const std::vector<int> cluster = strongly_connected(topology_.size(), edges);
  for (const auto& [from, to] : edges)
    if (cluster[static_cast<std::size_t>(from)] == cluster[static_cast<std::size_t>(to)])
      run_.together_[static_cast<std::size_t>(from)] = 1;
  order_outputs();
}

/// Each gives its outputs again whenever one that it feeds through has become right: at the place of an
/// output in the longest chain of feedthroughs that leads to it. There is no loop (Topology::check).
void RunStart::order_outputs() {
  const auto together = [&](int who) { return run_.together_[static_cast<std::size_t>(who)] != 0; };
  std::vector<std::vector<int>> level;
  for (int i = 0; i < topology_.size(); ++i)
    level.emplace_back(static_cast<std::size_t>(together(i) ? topology_.info(i).output_size() : 0));
  const auto of = [&](int who, int output) -> int& {
    return level[static_cast<std::size_t>(who)][static_cast<std::size_t>(output)];
  };
  int deepest = 0;
  for (bool more = true; more;) {
    more = false;
    for (const Line& line : topology_.lines())
      for (const Feedthrough& f : topology_.info(line.reader).feedthrough) {
        if (!together(line.source) || !together(line.reader) || f.input != line.input ||
            !topology_.at_once(line))
          continue;
        int& behind = of(line.reader, f.output);
        if (behind > of(line.source, line.output)) continue;
        deepest = std::max(deepest, behind = of(line.source, line.output) + 1);
        more = true;
      }
  }
  for (int depth = 0; depth <= deepest; ++depth)
    for (int i = 0; i < topology_.size(); ++i)
      if (const auto& mine = level[static_cast<std::size_t>(i)];
          together(i) && (depth == 0 || std::find(mine.begin(), mine.end(), depth) != mine.end()))
        run_.output_calls_.push_back(i);
}

}  // namespace tandem
