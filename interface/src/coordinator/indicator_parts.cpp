// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "indicator_parts.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/subsystem_info.hpp"

namespace tandem {

Indicators::Parts::Parts(const Coordinator& run, const std::vector<PowerLink>& links,
                         const std::vector<int>& left_out)
    : run_(run) {
  const Topology& topology = run.topology();
  for (std::size_t k = 0; k < topology.lines().size(); ++k) {
    const Line& line = topology.lines()[k];
    const Port& output = *scalar_at(topology.info(line.source).outputs, line.output).port;
    const bool out = std::count(left_out.begin(), left_out.end(), static_cast<int>(k)) > 0;
    if (out || output.held || topology.just_before(line)) continue;
    const std::string input = topology.input_name(line.reader, line.input);
    const bool sum = topology.lines_to(line.reader, line.input).size() > 1;
    const std::string from = sum ? ":" + topology.output_name(line.source, line.output) : "";
    connections_.push_back({.name = "defect(" + input + from + ")",
                            .unit = scalar_at(topology.info(line.reader).inputs, line.input).port->unit,
                            .line = static_cast<int>(k)});
  }
  for (const PowerLink& link : links)
    links_.push_back({.link = link, .name = "energy(" + name_of(topology, link) + ")"});
}

void Indicators::Parts::begin(double t_start) {
  if (!tracks_.empty()) return;
  const Topology& topology = run_.topology();
  const auto size = static_cast<std::size_t>(topology.size());
  for (int i = 0; i < topology.size(); ++i) tracks_.emplace_back(topology.info(i));
  unsettled_.resize(size), lanes_.resize(size), couplings_of_.resize(size), samplings_of_.resize(size);
  choose_windows(t_start);
  for (Connection& one : connections_) add_line(one);
  for (Link& link : links_) add_link(link);
}

void Indicators::Parts::choose_windows(double t_start) {
  double longest = 0.0;
  for (int i = 0; i < run_.topology().size(); ++i) longest = std::max(longest, run_.own_step(i));
  const double span = run_.t_stop() - t_start;
  const double cells = most_cells / static_cast<double>(connections_.size() + links_.size() + 1);
  const double steps = std::floor(span / longest * (1.0 + 1e-9)), most = std::min(cells, most_windows);
  windows_.count = static_cast<std::size_t>(std::max(1.0, std::min(steps, most)));
  windows_.begin = t_start, windows_.length = span / static_cast<double>(windows_.count);
  windows_.per_second = 1.0 / windows_.length;
  for (Connection& one : connections_) one.windows.assign(windows_.count, -1.0);
  for (Link& one : links_) one.windows.assign(windows_.count, 0.0);
}

void Indicators::Parts::add_line(Connection& told) {
  const Line& line = run_.topology().lines()[static_cast<std::size_t>(told.line)];
  LineDefect& defect = defects_.emplace_back(told, line, track(line.source).column(line.output));
  lanes_[static_cast<std::size_t>(line.reader)].push_back({run_.exchange().slot(told.line), &defect});
  if (sampled(line.reader))
    sampling(line.source, line.reader).add(defect);
  else
    coupling(line.source, line.reader).add(defect, line.source);
}

void Indicators::Parts::add_link(Link& link) {
  const Line& effort = run_.topology().lines()[static_cast<std::size_t>(link.link.effort)];
  coupling(effort.source, effort.reader)
      .add(link, *defect_of(link.link.effort), *defect_of(link.link.back), effort.source);
}

LineDefect* Indicators::Parts::defect_of(int line) {
  const auto it = std::lower_bound(connections_.begin(), connections_.end(), line,
                                   [](const Connection& one, int number) { return one.line < number; });
  return &defects_[static_cast<std::size_t>(it - connections_.begin())];
}

/// Of equal own steps the one that comes first is looked at as the fine one.
CouplingIndicator& Indicators::Parts::coupling(int a, int b) {
  const auto [first, second] = std::minmax(a, b);
  for (CouplingIndicator* one : couplings_of_[static_cast<std::size_t>(first)])
    if (one->is_between(first, second)) return *one;
  const bool second_is_fine = run_.own_step(second) < run_.own_step(first);
  CouplingIndicator& one =
      couplings_.emplace_back(second_is_fine ? second : first, second_is_fine ? first : second);
  couplings_of_[static_cast<std::size_t>(first)].push_back(&one);
  if (first != second) couplings_of_[static_cast<std::size_t>(second)].push_back(&one);
  return one;
}

SamplingIndicator& Indicators::Parts::sampling(int source, int reader) {
  for (SamplingIndicator* one : samplings_of_[static_cast<std::size_t>(reader)])
    if (one->source() == source && one->reader() == reader) return *one;
  SamplingIndicator& one = samplings_.emplace_back(source, reader);
  for (const int who : {source, reader}) samplings_of_[static_cast<std::size_t>(who)].push_back(&one);
  return one;
}

void Indicators::Parts::samples(int subsystem, const History& history, std::int64_t first,
                                std::int64_t last) {
  track(subsystem).add(history, first, last);
  std::int64_t& rows = unsettled_[static_cast<std::size_t>(subsystem)];
  if ((rows += last - first + 1) < rows_at_a_time) return;
  rows = 0;
  settle(subsystem);
  track(subsystem).drop_before(needed(subsystem));
}

/// Ended: it has told all of it.
TrackEnd Indicators::Parts::end(int who) {
  OutputTrack& track = this->track(who);
  return {track, run_.schedule().member(who).finished() && track.newest_time() >= run_.time(who)};
}

void Indicators::Parts::settle_all() {
  for (std::size_t i = 0; i < tracks_.size(); ++i) settle(static_cast<int>(i));
}

void Indicators::Parts::settle(int subsystem) {
  for (CouplingIndicator* one : couplings_of_[static_cast<std::size_t>(subsystem)])
    one->settle(end(one->fine()), end(one->coarse()), windows_);
  for (SamplingIndicator* one : samplings_of_[static_cast<std::size_t>(subsystem)])
    one->settle(track(one->source()), run_.schedule().member(one->reader()).finished(), windows_);
}

/// The first row that somebody still looks at.
std::int64_t Indicators::Parts::needed(int subsystem) const {
  std::int64_t row = tracks_[static_cast<std::size_t>(subsystem)].newest();
  for (const CouplingIndicator* one : couplings_of_[static_cast<std::size_t>(subsystem)])
    row = std::min(row, one->next_of(subsystem));
  for (const SamplingIndicator* one : samplings_of_[static_cast<std::size_t>(subsystem)])
    if (one->source() == subsystem) row = std::min(row, one->next());
  return row;
}

void Indicators::Parts::acted(int subsystem, double t) {
  for (SamplingIndicator* one : samplings_of_[static_cast<std::size_t>(subsystem)])
    if (one->reader() == subsystem) one->acted(t);
}

std::vector<double> Indicators::Parts::times() const {
  std::vector<double> all;
  for (std::size_t k = 1; k <= windows_.count; ++k)
    all.push_back(windows_.begin + windows_.length * static_cast<double>(k));
  return all;
}

void Indicators::Parts::write(ByteWriter& to) const {
  to.put(windows_.begin);
  for (const OutputTrack& one : tracks_) one.write(to);
  for (const LineDefect& one : defects_) one.used.write(to);
  for (const CouplingIndicator& one : couplings_) one.write(to);
  for (const SamplingIndicator& one : samplings_) one.write(to);
  for (const Connection& one : connections_) {
    for (const double number : {one.largest, one.at, one.peak}) to.put(number);
    to.put_list(one.windows);
  }
  for (const Link& one : links_) {
    for (const double number : {one.energy, one.passed}) to.put(number);
    to.put_list(one.windows);
  }
}

void Indicators::Parts::read(ByteReader& from) {
  const auto t_start = from.take<double>();
  if (!std::isfinite(t_start)) from.refuse("has indicators that begin at no time");
  begin(t_start);
  for (OutputTrack& one : tracks_) one.read(from);
  for (LineDefect& one : defects_) one.used.read(from);
  for (CouplingIndicator& one : couplings_) one.read(from, track(one.fine()), track(one.coarse()));
  for (SamplingIndicator& one : samplings_) one.read(from, track(one.source()));
  for (Connection& one : connections_) {
    for (double* number : {&one.largest, &one.at, &one.peak}) *number = from.take<double>();
    from.take_list(one.windows);
  }
  for (Link& one : links_) {
    for (double* number : {&one.energy, &one.passed}) *number = from.take<double>();
    from.take_list(one.windows);
  }
}

}  // namespace tandem
