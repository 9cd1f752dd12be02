// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// 30 s of the engine-linkage scene with one side elsewhere (F. Gonzalez's thesis, table 5.2 and figure 5.11).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "bench/bench.hpp"
#include "bench/served_process.hpp"
#include "engine_linkage/coupled.hpp"
#include "engine_linkage/linkage.hpp"
#include "engine_linkage/monolithic.hpp"
#include "sources/all.hpp"
#include "sources/this_program.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"
#include "tandem/output/files.hpp"

namespace tandem::bench {
namespace {

constexpr double motion = 30.0;  // [s]
constexpr int repeats = 3;
const std::string its_diagram = "scenarios/engine_linkage/engine.toml";

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

/// The scene with so many loops, both steps 1 ms, slowest-first, degree 3.
class Scene {
 public:
  explicit Scene(int loops) : loops_(loops), linkage_file_(folder_.file("linkage.toml")) {
    output::write_text(linkage_file_, engine_linkage::linkage_text(loops));
    builtins_ = all_sources({.tell = [](const std::string&) {}});
  }

  /// Seconds of the run without its start; `rows` gets what it computes.
  double run(const Way& way, Rows& rows) const {
    std::unique_ptr<ServedProcess> server;
    if (const auto served = linked_transports();
        std::find(served.begin(), served.end(), way.transport) != served.end())
      server = std::make_unique<ServedProcess>(file(way.side), way.transport, folder_);
    const auto side = [&](const std::string& name) {
      const std::string uri = way.side != name ? file(name) + "?"
                              : server         ? server->uri() + "&"
                                               : uri_of(way);
      return open(uri + parameters(name), builtins_);
    };
    engine_linkage::Coupled both(side("linkage"), side("engine"), {"slowest-first", "lagrange3", "lagrange3"},
                                 motion);
    Coordinator& coordinator = both.coordinator();
    coordinator.observe(&rows);
    coordinator.initialize();
    return seconds_of([&] {
      while (coordinator.round()) {
      }
    });
  }

  /// Seconds of the one equation that the engine's diagram with the linkage in it is, with the engine's
  /// steps.
  double run_monolithic() const {
    const auto both =
        engine::make_subsystem(engine_linkage::monolithic(engine::read_diagram(its_diagram), loops_), {1e-3});
    constexpr std::int64_t count = 30001;
    const auto size = both->info().row_size();
    std::vector<double> memory(static_cast<std::size_t>(count * size));
    Samples y(memory.data(), size, count);
    both->initialize(0.0, motion, {}, y);
    return seconds_of([&] { both->advance(motion, false, {}, y); });
  }

 private:
  std::string file(const std::string& side) const {
    return side == "engine" ? "diagram:" + std::filesystem::absolute(its_diagram).string()
                            : "mechanism:" + linkage_file_;
  }
  /// Of a side that needs no server.
  std::string uri_of(const Way& way) const {
    if (way.transport == "spawn") return "spawn:'" + this_program() + "' serve " + file(way.side) + "?";
    return "lib:" TANDEM_ENGINE_LINKAGE_LIBRARIES "/" +
           (way.side == "engine" ? "engine_library.so?"
                                 : fmt::format("linkage_of_loops.so?loops={}&", loops_));
  }
  static std::string parameters(const std::string& side) {
    return side == "engine" ? "step=1e-3" : "step=1e-3&penalty=1e10";
  }

  int loops_;
  LinkFolder folder_;
  std::string linkage_file_;
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
