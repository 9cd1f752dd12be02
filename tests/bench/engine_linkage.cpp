// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// 30 s of the engine-linkage scene with one side elsewhere (F. Gonzalez's thesis, table 5.2 and figure 5.11).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "bench/bench.hpp"
#include "bench/served_process.hpp"
#include "sources/all.hpp"
#include "sources/this_program.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::bench {
namespace {

constexpr double motion = 30.0;  // [s]
constexpr int repeats = 3;

/// Where the sides are: `side` ("engine", "linkage") elsewhere over the transport, or "none".
struct Way {
  std::string side, transport;
};

/// All rows of both sides, in the order of the run.
class Rows final : public Observer {
 public:
  Rows() { values_.reserve(1 << 19); }
  bool samples(int, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t k = first; k <= last; ++k) {
      values_.push_back(history.time(k));
      for (const double value : history.values(k)) values_.push_back(value);
    }
    return true;
  }
  bool same_bits(const Rows& other) const {
    return values_.size() == other.values_.size() &&
           std::memcmp(values_.data(), other.values_.data(), values_.size() * sizeof(double)) == 0;
  }

 private:
  std::vector<double> values_;
};

template <class Call>
double seconds_of(const Call& call) {
  const auto began = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// The scene with so many loops.
class Scene {
 public:
  explicit Scene(int loops) : loops_(loops), builtins_(all_sources({.tell = [](const std::string&) {}})) {}

  /// Seconds of the run without its start; `rows` gets what it computes.
  double run(const Way& way, Rows& rows) const {
    std::unique_ptr<ServedProcess> server;
    if (const auto served = linked_transports();
        std::find(served.begin(), served.end(), way.transport) != served.end())
      server = std::make_unique<ServedProcess>(here(way.side), way.transport, folder_);
    const auto source = [&](const std::string& side) {
      return "subsystems." + side + ".source=" +
             (way.side != side ? here(side)
              : server         ? server->uri()
                               : elsewhere(way));
    };
    const auto scenario =
        scenario::read(folder / "engine_linkage.toml", {source("linkage"), source("engine")});
    scenario::Assembly assembly(scenario, builtins_);
    assembly.coordinator().observe(&rows);
    assembly.initialize();
    return seconds_of([&] {
      while (assembly.coordinator().round()) {
      }
    });
  }

  /// Seconds of both in one diagram, with the engine's steps.
  double run_monolithic() const {
    const auto both =
        open(fmt::format("diagram:{}?step=1e-3&loops={}", (folder / "monolithic.toml").string(), loops_),
             builtins_);
    constexpr std::int64_t count = 1024;
    const auto size = both->info().row_size();
    std::vector<double> memory(static_cast<std::size_t>(count * size));
    Samples start(memory.data(), size, count);
    Clock clock = both->initialize(0.0, motion, {}, start);
    return seconds_of([&] {
      while (clock.time < motion) {
        Samples y(memory.data(), size, count);
        clock = both->advance(motion, false, {}, y);
      }
    });
  }

 private:
  std::string here(const std::string& side) const {
    return side == "engine" ? "diagram:" + (folder / "engine.toml").string()
                            : fmt::format("builtin:engine_linkage.linkage?loops={}", loops_);
  }
  /// Of a side that needs no server.
  std::string elsewhere(const Way& way) const {
    if (way.transport == "spawn") return "spawn:'" + program_beside("tandem") + "' serve " + here(way.side);
    return "lib:" TANDEM_FILE_LIBRARIES "/" +
           (way.side == "engine" ? "engine_library.so" : fmt::format("linkage_of_loops.so?loops={}", loops_));
  }

  inline static const std::filesystem::path folder = std::filesystem::absolute("scenarios/engine_linkage");
  int loops_;
  LinkFolder folder_;
  Builtins builtins_;
};

/// The first is the one that the others are compared with.
std::vector<Way> ways() {
  std::vector<Way> all = {{"none", "in-process"}, {"none", "monolithic"}};
  auto transports = linked_transports();
  transports.insert(transports.begin(), {"lib", "spawn"});
  for (const std::string& transport : transports)
    for (const char* side : {"engine", "linkage"}) all.push_back({side, transport});
  return all;
}

struct Timed {
  std::vector<double> seconds = {};
  bool same_bits = true;
  double median() const {
    auto sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

/// All ways in turns.
std::vector<Timed> time_ways(const Scene& scene, const std::vector<Way>& all,
                             const std::function<void()>& after_each) {
  std::vector<Timed> times(all.size());
  for (int r = 0; r < repeats; ++r) {
    Rows expected;
    for (std::size_t k = 0; k < all.size(); ++k) {
      Rows rows;
      if (all[k].transport == "monolithic") {
        times[k].seconds.push_back(scene.run_monolithic());
      } else {
        times[k].seconds.push_back(scene.run(all[k], k == 0 ? expected : rows));
        times[k].same_bits &= k == 0 || rows.same_bits(expected);
      }
      after_each();
    }
  }
  return times;
}

}  // namespace

Table engine_linkage_elsewhere(const Tick& tick) {
  Table table({"loops", "elsewhere", "transport", "seconds", "ratio", "same_bits"});
  const auto all = ways();
  const std::vector<int> counts = {5, 10, 20, 40};
  double done = 0.0;
  for (const int loops : counts) {
    const auto times = time_ways(
        Scene(loops), all, [&] { tick(++done / static_cast<double>(counts.size() * repeats * all.size())); });
    for (std::size_t k = 0; k < all.size(); ++k)
      table.add({std::to_string(loops), all[k].side, all[k].transport,
                 fmt::format("{:.4f}", times[k].median()),
                 fmt::format("{:.3f}", times[k].median() / times[0].median()),
                 all[k].transport == "monolithic" ? ""
                 : times[k].same_bits             ? "yes"
                                                  : "no"});
  }
  return table;
}

}  // namespace tandem::bench
