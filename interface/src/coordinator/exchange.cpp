// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tandem {
namespace {

double lag_of(Lag lag, int reader, const Lags& lags) {
  if (lag == Lag::memory) return lags.memory[static_cast<std::size_t>(reader)];
  return lag == Lag::delay ? lags.delay : 0.0;
}

/// Coefficients of p about another origin, p(t) = sum c_k (t - to)^k: a Taylor shift, added to `c`.
void add_shifted(const Segment& p, double to, double* c) {
  double d[TANDEM_MAX_COEFFICIENTS];
  std::copy(p.c, p.c + TANDEM_MAX_COEFFICIENTS, d);
  const double x = to - p.origin;
  for (int k = 0; k < TANDEM_MAX_COEFFICIENTS - 1; ++k)
    for (int i = TANDEM_MAX_COEFFICIENTS - 2; i >= k; --i) d[i] += x * d[i + 1];
  for (int k = 0; k < TANDEM_MAX_COEFFICIENTS; ++k) c[k] += d[k];
}

const Segment& piece(const Signal& signal, double end) {
  const auto segments = signal.segments();
  const auto it =
      std::find_if(segments.begin(), segments.end() - 1, [&](const Segment& s) { return end <= s.end; });
  return *it;
}

}  // namespace

Exchange::Exchange(const Topology& topology, TimeTolerance tolerance, const Lags& lags,
                   std::span<const std::int64_t> capacities)
    : tolerance_(tolerance) {
  for (int i = 0; i < topology.size(); ++i) {
    const auto inputs = static_cast<std::size_t>(topology.info(i).input_size());
    History history(topology.name(i), topology.info(i), capacities[static_cast<std::size_t>(i)]);
    ends_.push_back({std::move(history), {}, {}, inputs, std::vector<Signal>(inputs), {}, {}});
  }
  std::map<std::pair<int, int>, std::vector<std::size_t>> of_pairs;
  for (const Line& line : topology.lines())
    add_line(topology, line, lags, of_pairs[{line.source, line.reader}]);
  for (int i = 0; i < topology.size(); ++i) hold_start_values(topology, i);
  for (Link& link : links_) {
    link.attach(history(link.source()), tolerance_);
    ends_[static_cast<std::size_t>(link.source())].out.push_back(&link);
    ends_[static_cast<std::size_t>(link.reader())].in.push_back(&link);
  }
}

/// The link that this line belongs to: same source, reader, reconstruction and delay. of_pair: numbers of the
/// links between the two.
Link& Exchange::link_for(const Line& line, const Lags& lags, std::vector<std::size_t>& of_pair) {
  const double delay = lag_of(line.lag, line.reader, lags);
  for (const std::size_t k : of_pair)
    if (links_[k].how() == line.how && links_[k].delay() == delay) return links_[k];
  of_pair.push_back(links_.size());
  return links_.emplace_back(line.source, line.reader, line.how, delay);
}

void Exchange::add_line(const Topology& topology, const Line& line, const Lags& lags,
                        std::vector<std::size_t>& of_pair) {
  End& reader = ends_[static_cast<std::size_t>(line.reader)];
  auto slot = static_cast<std::size_t>(line.input);
  if (const auto terms = topology.lines_to(line.reader, line.input).size(); terms > 1) {
    const auto known =
        std::find_if(reader.sums.begin(), reader.sums.end(), [&](const Sum& s) { return s.input == slot; });
    Sum& sum =
        known != reader.sums.end() ? *known : reader.sums.emplace_back(Sum{slot, reader.slots.size(), 0, {}});
    if (sum.count == 0) reader.slots.resize(reader.slots.size() + terms);
    slot = sum.first + sum.count++;
  }
  link_for(line, lags, of_pair).add({line.output, static_cast<int>(slot), line.gain, line.offset});
}

/// Inputs without a connection keep their start value.
void Exchange::hold_start_values(const Topology& topology, int i) {
  End& reader = ends_[static_cast<std::size_t>(i)];
  const auto& start = topology.start(i);
  reader.constants.resize(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) {
    reader.constants[k].c[0] = start[k];
    reader.slots[k] = Signal(&reader.constants[k], 1, 0);
  }
}

/// The sum's breaks are those of all its terms; each piece has its origin at its end, where a term's node is,
/// so it too depends on the samples alone.
void Exchange::add_up(Sum& sum, std::span<Signal> slots) {
  const auto terms = slots.subspan(sum.first, sum.count);
  sum.segments.clear();
  for (const Signal& term : terms)
    for (const Segment& s : term.segments()) sum.segments.push_back(Segment{s.end, s.origin, {}});
  std::sort(sum.segments.begin(), sum.segments.end(), [](const Segment& a, const Segment& b) {
    return a.end != b.end ? a.end < b.end : a.origin < b.origin;
  });
  const auto last = std::unique(sum.segments.begin(), sum.segments.end(),
                                [](const Segment& a, const Segment& b) { return b.origin <= a.end; });
  sum.segments.erase(last, sum.segments.end());
  int degree = 0;
  for (Segment& s : sum.segments)
    for (const Signal& term : terms) add_shifted(piece(term, s.end), s.origin, s.c);
  for (const Signal& term : terms) degree = std::max(degree, static_cast<int>(term.degree()));
  slots[sum.input] = Signal(sum.segments.data(), static_cast<std::int32_t>(sum.segments.size()), degree);
}

void Exchange::make_room(int source, std::int64_t wanted) {
  End& end = ends_[static_cast<std::size_t>(source)];
  std::int64_t keep = end.history.newest();
  for (Link* link : end.out) {
    const History& reader = history(link->reader());
    keep = reader.empty() ? end.history.oldest()
                          : std::min(keep, link->oldest_needed(reader.time(reader.newest())));
  }
  end.history.make_room(keep, wanted);
  for (Link* link : end.out) link->follow_room();
}

void Exchange::reach_back() {
  for (Link& link : links_)
    if (link.how().follows_samples()) link.reach_back();
}

}  // namespace tandem
