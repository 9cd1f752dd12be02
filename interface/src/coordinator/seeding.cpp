// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {

/// Which output gives too few derivatives for a start from them; empty if none does.
std::string RunStart::lacks_derivatives() const {
  for (const Line& line : topology_.lines()) {
    if (!seeds_needed(line)) continue;
    const int given = scalar_at(topology_.info(line.source).outputs, line.output).port->derivatives,
              needed = line.how.derivatives_at_start();
    if (given < needed)
      return "output " + topology_.output_name(line.source, line.output) + " gives " + std::to_string(given) +
             " derivatives, and " + line.how.name() + " needs " + std::to_string(needed) + " of it";
  }
  return {};
}

/// Who stands against a repeated start; empty if nobody does.
std::string RunStart::does_not_repeat() const {
  for (int i = 0; i < topology_.size(); ++i) {
    const Abilities& a = topology_.info(i).abilities;
    const std::string name = "subsystem '" + topology_.name(i) + "' ";
    if (a.sampled) return name + "is sampled";
    if (!a.restarts) return name + "can't restart";
    if (a.events && !a.lands) return name + "has events and can't shorten a step";
  }
  for (const Line& line : topology_.lines())
    if (line.how.kind == Reconstruction::Kind::matched_hold)
      return "input " + topology_.input_name(line.reader, line.input) + " is a matched hold";
  return {};
}

/// The start that is asked for, or the best that there is. Notes a cold one that costs order.
StartKind RunStart::choose() {
  const auto& lines = topology_.lines();
  const StartKind asked = run_.coordination_.start;
  const std::string lacking = lacks_derivatives(), staying = does_not_repeat();
  if (asked == StartKind::derivatives && !lacking.empty())
    throw Error(ErrorCode::not_supported, "start from derivatives: " + lacking);
  if (asked == StartKind::repeat && !staying.empty())
    throw Error(ErrorCode::not_supported, "repeated start: " + staying);
  if (asked != StartKind::automatic) return asked;
  if (std::none_of(lines.begin(), lines.end(), [&](const Line& line) { return seeds_needed(line); }))
    return StartKind::cold;
  if (lacking.empty()) return StartKind::derivatives;
  if (staying.empty()) return StartKind::repeat;
  note_cold(lacking + "; " + staying);
  return StartKind::cold;
}

void RunStart::note_cold(const std::string& why) const {
  run_.notes_.push_back(
      "cold start: " + why +
      "; the order stays at 2 where inputs are extrapolated, at 3 where they are interpolated");
}

/// By source: past samples that its widest reader takes.
std::vector<int> RunStart::seeds() const {
  std::vector<int> counts(run_.own_steps_.size());
  for (const Line& line : topology_.lines())
    if (seeds_needed(line)) {
      int& count = counts[static_cast<std::size_t>(line.source)];
      count = std::max(count, line.how.samples() - 1);
    }
  return counts;
}

/// Weights of rows at these times, of which a polynomial is the value at t (J. L. Lagrange).
static std::vector<double> weights(const std::vector<double>& times, double t) {
  std::vector<double> all;
  for (const double own : times) {
    double weight = 1.0;
    for (const double other : times)
      if (other != own) weight *= (t - other) / (own - other);
    all.push_back(weight);
  }
  return all;
}

/// The row at t of the polynomial through those of these times, the first of which is the start.
std::vector<double> RunStart::row_at(int who, const std::vector<double>& times, double t) const {
  const History& history = run_.exchange_->history(who);
  const auto of_rows = weights(times, t);
  std::vector<double> row{t, 0.0};
  for (std::int64_t column = Samples::header; column < history.stride(); ++column) {
    double value = 0.0;
    for (std::size_t k = 0; k < of_rows.size(); ++k)
      value += of_rows[k] * history.row(history.first_own() + static_cast<std::int64_t>(k))[column];
    row.push_back(value);
  }
  return row;
}

/// Rows at t_start - k h, the oldest first, of the polynomial through as many rows from the start on.
std::vector<double> RunStart::past_of(int who, int count) const {
  const History& history = run_.exchange_->history(who);
  const std::int64_t first = history.first_own();
  std::vector<double> times, all;
  for (std::int64_t k = first; k <= std::min(first + count, history.newest()); ++k)
    times.push_back(history.time(k));
  for (int k = count; k > 0; --k) {
    const auto row = row_at(who, times, run_.t_start_ - k * run_.own_step(who));
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

/// Of a run that pauses, whose inputs are known at the start alone: what the passes gave makes a past, and all
/// stand at the start again.
void RunStart::seed_from_passes() {
  const std::vector<int> counts = seeds();
  for (int i = 0; i < topology_.size(); ++i) past_.push_back(past_of(i, counts[static_cast<std::size_t>(i)]));
  open_exchange(counts);
  for (int i = 0; i < topology_.size(); ++i) run_.stand(i, start_again(i));
}

}  // namespace tandem
