// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "bench/bench.hpp"
#include "functions/ways.hpp"

namespace tandem::bench {
namespace {

/// The quickest of several.
functions::Outcome quickest(const functions::Way& way, const functions::Motion& motion, int repetitions) {
  functions::Outcome best = way.run(motion);
  for (int r = 1; r < repetitions; ++r) {
    functions::Outcome next = way.run(motion);
    if (next.seconds < best.seconds) best = std::move(next);
  }
  return best;
}

}  // namespace

Table function_evaluation() {
  Table table({"interface", "step", "iterations", "seconds", "ratio", "difference"});
  for (const functions::Motion motion : {functions::Motion{1e-3, 10000}, functions::Motion{1e-2, 1000}}) {
    functions::Outcome plain;
    for (const functions::Way& way : functions::ways()) {
      const functions::Outcome o = quickest(way, motion, way.name == "pipe" ? 2 : 5);
      if (way.name == "cpp") plain = o;
      table.add({way.name, fmt::format("{}", motion.step), fmt::format("{}", o.iterations),
                 fmt::format("{:.4g}", o.seconds), fmt::format("{:.3g}", o.seconds / plain.seconds),
                 fmt::format("{:.1e}", (o.q - plain.q).cwiseAbs().maxCoeff())});
    }
  }
  return table;
}

}  // namespace tandem::bench
