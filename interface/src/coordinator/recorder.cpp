// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/recorder.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "recorder_file.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem {
namespace {

constexpr std::size_t doubles_reserved = std::size_t{1} << 16;  // by subsystem

/// "" of "", which says nothing.
std::string per_second(const std::string& unit) {
  if (unit.empty()) return "";
  const bool product = unit.find_first_of(" /") != std::string::npos;
  return (product ? "(" + unit + ")" : unit) + "/s";
}

/// "x" of "x[2]": what names all elements of an array port.
std::string whole_port(const std::string& scalar) { return scalar.substr(0, scalar.find('[')); }

}  // namespace

std::string unknown_output(const std::vector<std::string>& outputs, const std::vector<std::string>& ports) {
  std::unordered_set<std::string> known(outputs.begin(), outputs.end());
  for (const std::string& scalar : outputs) known.insert(whole_port(scalar));
  const auto it = std::find_if(ports.begin(), ports.end(),
                               [&](const std::string& port) { return !known.contains(port); });
  return it == ports.end() ? "" : unknown("recorded output", *it, outputs);
}

Recorder::Recorder(const Coordinator& run, Recording what) : run_(run), what_(std::move(what)) {
  if (!what_.clock.empty()) {
    const auto clock = run.topology().instance(what_.clock);
    if (!clock)
      throw Error(ErrorCode::invalid_argument, unknown("clock", what_.clock, run.topology().names()));
    clock_ = *clock;
  }
  if (const auto why = unknown_output(run.topology().output_names(), what_.ports); !why.empty())
    throw Error(ErrorCode::invalid_argument, why);
  choose_columns();
}

Recorder::~Recorder() {
  try {
    close();
  } catch (...) {  // whoever wants to know calls close()
  }
}

std::string_view Recorder::name(Fill fill) {
  constexpr std::string_view names[] = {"own steps", "cubic hermite", "linear", "held"};
  return names[static_cast<std::size_t>(fill)];
}

void Recorder::choose_columns() {
  const Topology& topology = run_.topology();
  const std::unordered_set<std::string> ports(what_.ports.begin(), what_.ports.end());
  for (int i = 0; i < topology.size(); ++i) {
    Track& track = tracks_.emplace_back();
    track.sampled = topology.info(i).abilities.sampled;
    const auto names = topology.output_names(i);
    int output = 0;
    for (const Port& port : topology.info(i).outputs)
      for (int e = 0; e < port.size; ++e, ++output) {
        const std::string& scalar = names[static_cast<std::size_t>(output)];
        if (!ports.empty() && !ports.contains(scalar) && !ports.contains(whole_port(scalar))) continue;
        track.outputs.push_back(output);
        track.has_slope.push_back(port.derivatives > 0);
        track.held.push_back(port.held);
        const Fill fill = port.held ? Fill::held : port.derivatives > 0 ? Fill::hermite : Fill::linear;
        columns_.push_back({i, scalar, port.unit, fill});
        if (writes_slope(track, track.outputs.size() - 1))
          columns_.push_back({i, "der(" + scalar + ")", per_second(port.unit), fill});
      }
  }
}

std::vector<std::filesystem::path> Recorder::files() const {
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; i < (what_.own ? tracks_.size() : 1); ++i)
    if (has_file(i)) paths.push_back(path_of(i));
  return paths;
}

bool Recorder::samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) {
  if (files_.empty()) {
    start(history.time(first));
    open_files();
  }
  Track& track = tracks_[static_cast<std::size_t>(subsystem)];
  if (track.outputs.empty() && subsystem != clock_) return true;
  for (std::int64_t row = first; row <= last; ++row) {
    const double* y = history.values(row).data();
    track.rows.insert(track.rows.end(), {history.time(row), history.jump(row) ? 1.0 : 0.0});
    for (const int k : track.outputs) track.rows.push_back(y[k]);
    for (std::size_t k = 0; k < track.outputs.size(); ++k)
      track.rows.push_back(track.has_slope[k] ? y[history.outputs() + track.outputs[k]] : 0.0);
  }
  return true;
}

void Recorder::between_rounds() {
  const auto half_full = [](const Track& track) { return track.rows.size() > track.rows.capacity() / 2; };
  if (std::none_of(tracks_.begin(), tracks_.end(), half_full)) return;
  write_waiting(false);
  for (Track& track : tracks_)
    if (half_full(track)) track.rows.reserve(2 * track.rows.capacity());
}

void Recorder::start(double t_start) {
  t_start_ = t_start;
  tolerance_ = TimeTolerance(t_start);
  if (clock_ < 0) clock_ = smallest_step();
  RowRules rules = what_.rows;
  rules.to = std::min(rules.to, run_.t_stop());  // a sample may take effect later
  choices_.assign(what_.own ? tracks_.size() : 1, RowChoice(rules, t_start));
  for (Track& track : tracks_) track.rows.reserve(doubles_reserved);
  for (Column& column : columns_)
    if ((what_.own || column.subsystem == clock_) && column.fill != Fill::held) column.fill = Fill::own;
}

int Recorder::smallest_step() const {
  const auto rank = [this](int i) {
    return std::pair(run_.topology().info(i).abilities.sampled, run_.own_step(i));
  };
  int best = 0;
  for (int i = 1; i < run_.topology().size(); ++i)
    if (rank(i) < rank(best)) best = i;
  return best;
}

}  // namespace tandem
