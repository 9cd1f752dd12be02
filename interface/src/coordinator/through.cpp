// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that jump, and outputs that jump with them at once. Who stands at such a jump tells the outputs
// after it at the begin of its next call. Whoever stands there too, or past it, and reads one of them waits
// for that row, also if it leads; else it would go on with what was before, and err to first order.
#include <algorithm>

#include "feedthrough.hpp"
#include "run_start.hpp"

namespace tandem {
/// By subsystem whether inputs that feed through may jump.
std::vector<char> RunStart::jump_with_inputs() const {
  std::vector<char> all(clocks_.size());
  for (int i = 0; i < topology_.size(); ++i) all[static_cast<std::size_t>(i)] = outputs_jump(i);
  for (bool more = true; more;) {
    more = false;
    for (const Line& line : topology_.lines()) {
      char& reader = all[static_cast<std::size_t>(line.reader)];
      const bool may = line.how.kind == Reconstruction::Kind::held ||
                       topology_.info(line.source).abilities.events ||
                       all[static_cast<std::size_t>(line.source)] != 0;
      if (reader != 0 || sampled(line.reader) || !may || !feeds(topology_.info(line.reader), line.input))
        continue;
      reader = 1, more = true;
    }
  }
  return all;
}

void RunStart::note_followers() {
  std::vector<int> all;
  for (int i = 0; i < topology_.size(); ++i)
    if (jumps_[static_cast<std::size_t>(i)] != 0) all.push_back(i);
  run_.followers_ = sources_first(all);
}

void RunStart::note_through() {
  if (run_.coordination_.pauses) note_followers();
  if (std::find(jumps_.begin(), jumps_.end(), 1) == jumps_.end()) return;
  run_.through_.resize(clocks_.size());
  run_.awaiting_.reserve(clocks_.size());
  for (const Line& line : topology_.lines()) {
    const auto by_name = [&](const Through& t) { return t.source == line.source; };
    if (sampled(line.reader) || line.source == line.reader || !jumps_through(line)) continue;
    auto& sources = run_.through_[static_cast<std::size_t>(line.reader)];
    auto it = std::find_if(sources.begin(), sources.end(), by_name);
    if (it == sources.end()) it = sources.insert(it, {line.source, false});
    it->at_once = it->at_once || (topology_.at_once(line) && feeds(topology_.info(line.reader), line.input));
  }
  for (auto& sources : run_.through_)
    std::sort(sources.begin(), sources.end(), [this](const Through& a, const Through& b) {
      return topology_.name(a.source) < topology_.name(b.source);
    });
}

/// In an order that the file does not decide, as one that tells a jump may read what another told before.
void Coordinator::await_jumps(std::span<const Turn> turns) {
  awaiting_.clear();
  for (const Turn& turn : turns) awaiting_.push_back(turn.who);
  std::sort(awaiting_.begin(), awaiting_.end(),
            [this](int a, int b) { return topology_.name(a) < topology_.name(b); });
  for (const int who : awaiting_) await_jumps(who, false);
}

/// Of those that it reads and that do not stand past it; before, of those that these read at once. (There are
/// no circles of these.)
void Coordinator::await_jumps(int reader, bool at_once) {
  for (const Through& through : through_[static_cast<std::size_t>(reader)]) {
    const double t = time(through.source);
    if (at_once > through.at_once || tolerance_.before(time(reader), t)) continue;
    await_jumps(through.source, true);
    if (exchange_->jumps_at(through.source, t)) tell_jump(through.source);
  }
}

}  // namespace tandem
