// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Jumps that come to a reader through others, whose outputs follow their inputs at once. It ends a step where these jump,
// which is known beforehand, and waits there for all that stand between.
#include <cmath>

#include "feedthrough.hpp"
#include "run_start.hpp"

namespace tandem {

/// Its source gives a second row where its own inputs jump.
bool RunStart::jumps_through(const Line& line) const {
  return jumps_[static_cast<std::size_t>(line.source)] != 0 &&
         follows(topology_.info(line.source), line.output);
}

/// Who reads an input of this line's reader at once through that one, or through more: each once.
std::vector<int> RunStart::reached_at_once(const Line& line) const {
  std::vector<int> through, all;
  const auto reach = [&](int who, int input) {
    if (!sampled(who) && feeds(topology_.info(who), input)) add_once(through, who);
  };
  reach(line.reader, line.input);
  for (std::size_t k = 0; k < through.size(); ++k)
    for (const int number : topology_.lines_from(through[k])) {
      const Line& next = topology_.lines()[static_cast<std::size_t>(number)];
      if (next.lag != Lag::none || sampled(next.reader) || !follows(topology_.info(next.source), next.output))
        continue;
      add_once(all, next.reader);
      reach(next.reader, next.input);
    }
  return all;
}

void RunStart::note_watches() {
  jumps_ = jump_with_inputs();
  for (const Line& line : topology_.lines()) {
    if (sampled(line.reader) || !sampled(line.source)) continue;
    for (const int reader : reached_at_once(line)) {
      add_watch({reader, line.source, line.output, lag_of(line)});
      end_steps_beside(reader);
    }
  }
}

void RunStart::add_watch(const Watch& watch) {
  for (const Watch& known : times_.watches)
    if (known.reader == watch.reader && known.source == watch.source && known.output == watch.output &&
        known.lag == watch.lag)
      return;
  times_.watches.push_back(watch);
}

/// Beside its own nodes, if it can.
void RunStart::end_steps_beside(int who) {
  if (std::isfinite(times_.shortest_period[static_cast<std::size_t>(who)]))
    times_.nearest[static_cast<std::size_t>(who)] = nearest_node(who);
}

/// It waits for the samples that it watches as for those that it reads.
void RunStart::add_watched(std::vector<Read>& reads) const {
  for (const Watch& watch : times_.watches)
    reads.push_back({watch.reader, watch.source, topology_.info(watch.source).sampling.latency + watch.lag,
                     false, lands(watch)});
}

/// At the samples.
bool RunStart::lands(const Watch& watch) const {
  return topology_.info(watch.source).sampling.period >=
         times_.shortest_period[static_cast<std::size_t>(watch.reader)];
}

/// Who reads what follows another at once waits for that one too.
void RunStart::add_sources_behind(std::vector<Read>& reads) const {
  for (const Line& line : topology_.lines())
    if (line.lag == Lag::none && !sampled(line.source) && jumps_through(line))
      for (const int reader : reached_at_once(line))
        if (reader != line.source) reads.push_back({reader, line.source});
}

}  // namespace tandem
