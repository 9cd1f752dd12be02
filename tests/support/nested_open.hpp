// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run_bench.hpp"
#include "scratch.hpp"
#include "sources/all.hpp"

namespace tandem::test {

/// A scenario as one subsystem: its file, with parameters if wanted.
inline std::unique_ptr<Subsystem> nested(const std::string& uri, std::vector<std::string> overrides = {}) {
  return open("scenario:" + uri, all_sources(), {{}, {}, {}, std::move(overrides)});
}
inline std::string place(const Scratch& folder, const char* file) { return (folder.path() / file).string(); }

inline Recording alone(Subsystem& subsystem, double stop) {
  RunBench bench;
  bench.add("all", subsystem);
  return bench.run(stop);
}

}  // namespace tandem::test
