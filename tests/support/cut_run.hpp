// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "tandem/bytes.hpp"

namespace tandem::test {

/// The rows of a run that is made by `before` for so many rounds, and from there on by `after`, put together
/// alike, which knows nothing of it but bytes.
inline std::vector<Recording::Rows> cut_after(int rounds, RunBench& before, RunBench& after, TimeSpan span) {
  Coordinator& first = before.make(span.stop, span.start);
  first.observe(&before.recording);
  first.initialize();
  for (int round = 0; round < rounds && first.round(); ++round) {
  }
  ByteWriter bytes;
  first.save(bytes);
  Coordinator& second = after.make(span.stop, span.start);
  second.initialize();
  ByteReader from(bytes.bytes(), "run", "checkpoint of");
  second.restore(from);
  from.end();
  second.observe(&after.recording);
  while (second.round()) {
  }
  auto rows = before.recording.all();
  for (std::size_t who = 0; who < after.recording.all().size(); ++who) {
    const auto& more = after.recording.all()[who];
    rows[who].insert(rows[who].end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace tandem::test
