// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Round trips of an advance over each transport, beside the same bytes without tandem.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "bench/answer_link.hpp"
#include "bench/bench.hpp"
#include "bench/in_turns.hpp"
#include "bench/raw_link.hpp"

namespace tandem::bench {
namespace {

constexpr double hybrid_spin = 50e-6;  // s, the default of the parameter spin
constexpr int exchanges = 4000;

std::string micro(double seconds) { return fmt::format("{:.3f}", 1e6 * seconds); }

std::unique_ptr<RawLink> raw_link([[maybe_unused]] const LinkFolder& folder, const std::string& transport,
                                  const Sizes& sizes, bool spins) {
#if TANDEM_HAS_ZEROMQ
  if (transport.starts_with("zmq:"))
    return raw_zeromq(transport == "zmq:ipc" ? "ipc://" + folder.file("raw") : "tcp://127.0.0.1:*", sizes,
                      transport == "zmq:curve");
#endif
  return raw_sockets(transport, sizes, spins);
}

InTurns over(const std::string& transport, const Shape& shape, bool hybrid, int count) {
  const LinkFolder folder;
  AnswerLink link(transport, shape, hybrid ? hybrid_spin : 0.0, folder);
  const auto raw = raw_link(folder, transport, sizes_of(shape), hybrid);
  return measure_in_turns([&] { link.exchange(); }, [&] { raw->exchange(); }, count);
}

/// The table of functions beside the same subsystem without it.
InTurns by_table(const Shape& shape) {
  const auto behind = answer_by_table(shape), direct = answer(shape);
  Asking ours(*behind, shape), theirs(*direct, shape);
  return measure_in_turns([&] { ours.once(); }, [&] { theirs.once(); }, exchanges, 100);
}

/// One row back by the table, beside an empty call through a function pointer.
InTurns by_empty_call() {
  const Shape least{1, 1};
  const auto behind = answer_by_table(least);
  Asking ours(*behind, least);
  void (*volatile empty)() = [] {};
  return measure_in_turns([&] { ours.once(); }, [&] { empty(); }, exchanges, 100);
}

void add_row(Table& table, const std::string& transport, const std::string& wait, const Shape& shape,
             const InTurns& t) {
  table.add({transport, wait, wait == "none" ? transport : transport + " " + wait,
             std::to_string(shape.signals), std::to_string(shape.samples), micro(t.tandem.median),
             micro(t.tandem.p99), micro(t.raw.median),
             fmt::format("{:.3f}", t.tandem.median / t.raw.median)});
}

/// Whether it spins: ZeroMQ only sleeps.
std::vector<bool> waits(const std::string& transport) {
  return transport.starts_with("zmq:") ? std::vector{false} : std::vector{true, false};
}

Table round_trips(const Tick& tick) {
  Table table(
      {"transport", "wait", "link", "signals", "samples", "median_us", "p99_us", "raw_median_us", "ratio"});
  const Shape shapes[] = {{4, 1}, {4, 100}};
  const auto transports = linked_transports();
  add_row(table, "lib", "none", {1, 1}, by_empty_call());
  for (const Shape& shape : shapes) add_row(table, "lib", "none", shape, by_table(shape));
  double done = 0.0;
  for (const std::string& transport : transports) {
    for (const bool hybrid : waits(transport))
      for (const Shape& shape : shapes)
        add_row(table, transport, hybrid ? "hybrid" : "block", shape,
                over(transport, shape, hybrid, exchanges));
    tick(0.7 * ++done / static_cast<double>(transports.size()));
  }
  return table;
}

/// Seconds to copy the bytes of an exchange once.
double copying(const Sizes& sizes, int count) {
  const std::vector<std::byte> from(sizes.request + sizes.reply, std::byte{1});
  std::vector<std::byte> to(from.size());
  const auto copy = [&] { std::memcpy(to.data(), from.data(), from.size()); };
  return measure_in_turns(copy, copy, count).tandem.median;
}

Table throughput(const Tick& tick) {
  Table table({"transport", "signals", "bytes", "median_us", "mb_per_s", "raw_median_us", "copy_us", "ratio"},
              "throughput");
  const auto transports = linked_transports();
  double done = 0.0;
  for (const int signals : {10, 100, 1000, 10000, 100000}) {
    const Shape shape{signals, 1};
    const Sizes sizes = sizes_of(shape);
    const auto bytes = static_cast<double>(sizes.request + sizes.reply);
    const int count = static_cast<int>(std::clamp(2e8 / bytes, 50.0, 2000.0));
    const double copy = copying(sizes, count);
    for (const std::string& transport : transports) {
      const InTurns t = over(transport, shape, false, count);
      table.add({transport, std::to_string(signals), fmt::format("{:.0f}", bytes), micro(t.tandem.median),
                 fmt::format("{:.1f}", 1e-6 * bytes / t.tandem.median), micro(t.raw.median), micro(copy),
                 fmt::format("{:.3f}", t.tandem.median / t.raw.median)});
      tick(0.7 + 0.3 * ++done / static_cast<double>(5 * transports.size()));
    }
  }
  return table;
}

}  // namespace

std::vector<Table> transports(const Tick& tick) { return {round_trips(tick), throughput(tick)}; }

}  // namespace tandem::bench
