// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "named.hpp"
#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

/// Most feedthroughs that a value passes one behind another at one instant; there is no loop
/// (Topology::check).
int longest_feedthrough(const Topology& topology) {
  std::vector<std::vector<int>> passed;
  for (int i = 0; i < topology.size(); ++i)
    passed.emplace_back(static_cast<std::size_t>(topology.info(i).input_size()));
  const auto at = [&](int i, int k) -> int& {
    return passed[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  };
  int longest = 0;
  for (bool more = true; more && longest <= static_cast<int>(topology.lines().size());) {
    more = false;
    for (const Line& line : topology.lines())
      for (const Feedthrough& f : topology.info(line.source).feedthrough) {
        int& behind = at(line.reader, line.input);
        if (!topology.at_once(line) || f.output != line.output || behind > at(line.source, f.input)) continue;
        longest = std::max(longest, behind = at(line.source, f.input) + 1);
        more = true;
      }
  }
  return longest;
}

}  // namespace

bool RunStart::derivatives_suffice() const {
  return std::all_of(topology_.lines().begin(), topology_.lines().end(), [&](const Line& line) {
    return !seeds_needed(line) ||
           scalar_at(topology_.info(line.source).outputs, line.output).port->derivatives >=
               line.how.derivatives_at_start();
  });
}

bool RunStart::can_repeat() const {
  for (int i = 0; i < topology_.size(); ++i)
    if (!topology_.info(i).abilities.restarts || sampled(i)) return false;
  return std::none_of(topology_.lines().begin(), topology_.lines().end(),
                      [](const Line& line) { return line.how.kind == Reconstruction::Kind::matched_hold; });
}

/// The start that is asked for, or the best that there is. Notes a cold one that costs order.
StartKind RunStart::choose() {
  const auto& lines = topology_.lines();
  const StartKind asked = run_.coordination_.start;
  const std::string needs = "the outputs give too few derivatives for the degrees of their connections";
  const std::string stays =
      "not every subsystem can restart, one is sampled, or a connection is a matched hold";
  if (asked == StartKind::derivatives && !derivatives_suffice())
    throw Error(ErrorCode::not_supported, "start from derivatives: " + needs);
  if (asked == StartKind::repeat && !can_repeat())
    throw Error(ErrorCode::not_supported, "repeated start: " + stays);
  if (asked != StartKind::automatic) return asked;
  if (std::none_of(lines.begin(), lines.end(), [&](const Line& line) { return seeds_needed(line); }))
    return StartKind::cold;
  if (derivatives_suffice()) return StartKind::derivatives;
  if (can_repeat()) return StartKind::repeat;
  run_.notes_.push_back(
      "cold start: " + needs + ", and " + stays +
      "; the order stays at 2 where inputs are extrapolated, at 3 where they are interpolated");
  return StartKind::cold;
}

/// Past samples at t_start - k h by Taylor expansion, as many as the widest reader of each source takes.
void RunStart::seed() {
  std::vector<int> counts(run_.own_steps_.size());
  for (const Line& line : topology_.lines())
    if (seeds_needed(line)) {
      int& count = counts[static_cast<std::size_t>(line.source)];
      count = std::max(count, line.how.samples() - 1);
    }
  open_exchange(counts);
}

/// Waveform relaxation over as many of the largest own steps as a reconstruction takes samples (d + 1 at
/// degree d): a first pass on held inputs, then passes on inputs interpolated in the pass before. The first
/// pass leaves an error of order 2 in the states. Each further one gains at least one order if no output
/// feeds an input through; with feedthroughs one behind another it takes one pass more for each until what
/// was gained has come round. So (d + 1) (1 + feedthroughs) passes reach order d + 1 whatever the coupling.
/// The run goes on from the last pass.
void RunStart::repeat() {
  int degree = 0, samples = 0;
  for (const Line& line : topology_.lines())
    if (line.how.follows_samples()) {
      degree = std::max(degree, line.how.polynomial_degree());
      samples = std::max(samples, line.how.samples());
    }
  const double largest = *std::max_element(run_.own_steps_.begin(), run_.own_steps_.end());
  const double until = std::min(run_.t_start_ + samples * largest, run_.t_stop_);
  const int passes = (degree + 1) * (1 + longest_feedthrough(topology_));
  for (int count = 0; count < passes; ++count) {
    Exchange before = std::move(*run_.exchange_);
    if (count > 0) before.reach_back();
    open_exchange(std::vector<int>(run_.own_steps_.size()));
    for (int i = 0; i < topology_.size(); ++i) pass(i, before, until);
  }
}

/// The subsystem starts again and goes to its last own node at or before `until`, step by step, on the
/// signals of `before`.
void RunStart::pass(int who, Exchange& before, double until) {
  const auto i = static_cast<std::size_t>(who);
  std::vector<double> memory(static_cast<std::size_t>(topology_.info(who).row_size()));
  Samples first(memory.data(), topology_.info(who).row_size(), 1);
  const Member& member = run_.schedule_->member(who);
  Subsystem* const subsystem = run_.seats_[i].subsystem;
  const Clock start = named(
      topology_.name(who), [&] { return subsystem->initialize(run_.t_start_, run_.t_stop_, u0_[i], first); });
  run_.stand(who, start);
  while (!run_.tolerance_.before(until, member.next)) {
    const bool land = member.lands && !run_.tolerance_.before(member.next, run_.t_stop_);
    run_.take({who, member.next, land}, before);
  }
  run_.exchange_->commit(who, until);
}

}  // namespace tandem
