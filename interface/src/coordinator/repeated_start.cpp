// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The first steps, run again and again until they are right.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../number_text.hpp"
#include "named.hpp"
#include "run_start.hpp"

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

/// What all subsystems read in a span, as one pass after the other left it.
class Waveforms {
 public:
  explicit Waveforms(TimeSpan span) : span_(span) {}

  /// Of one subsystem, each time in the same order.
  void note(std::span<const Signal> inputs) {
    for (const Signal& u : inputs)
      for (std::size_t k = 1; k <= instants; ++k)
        now_.push_back(u.value(span_.start + (span_.stop - span_.start) * static_cast<double>(k) / instants));
  }
  /// By how much a pass has changed them: the largest change of all, for an input whose magnitude is 1.
  double change() {
    magnitudes_.resize(now_.size() / instants);
    double largest = 0.0;
    for (std::size_t k = 0; k < now_.size(); ++k) {
      double& magnitude = magnitudes_[k / instants];
      for (std::size_t i = k; k % instants == 0 && i < k + instants; ++i)
        magnitude = std::max(magnitude, std::abs(now_[i]));
      if (!before_.empty() && magnitude > 0.0)
        largest = std::max(largest, std::abs(now_[k] - before_[k]) / magnitude);
    }
    before_ = std::exchange(now_, {});
    return largest;
  }

 private:
  static constexpr std::size_t instants = 16;

  TimeSpan span_;
  std::vector<double> before_, now_;  ///< by input, then by instant
  std::vector<double> magnitudes_;    ///< by input
};

/// changes: by how much each pass changed what is read. The last is near to what all further ones would give.
/// Where outputs feed inputs through it takes several passes until a change has come round: they are looked
/// at together. Below the floor there is nothing but rounding, and what iterations within a step leave.
bool settled(const std::vector<double>& changes, std::ptrdiff_t round) {
  constexpr double floor = 1e-10;
  const auto largest = [&](auto from) { return *std::max_element(from, from + round); };
  const double last = largest(changes.end() - round);
  return std::ssize(changes) == round || last <= floor ||
         (last <= 0.1 * largest(changes.begin()) && last < largest(changes.end() - 2 * round));
}

}  // namespace

/// Waveform relaxation over as many of the largest own steps as a reconstruction takes samples (d + 1 at
/// degree d): a first pass on held inputs, then passes on inputs interpolated in the pass before. The first
/// pass leaves an error of order 2 in the states. Each further one gains at least one order if no output
/// feeds an input through; with feedthroughs one behind another it takes one pass more for each until what
/// was gained has come round. So (d + 1) (1 + feedthroughs) passes reach order d + 1 whatever the coupling.
/// The run goes on from the last pass, if that is near to what all further ones would give.
void RunStart::repeat() {
  const auto [passes, round, until, largest] = first_steps();
  Waveforms read({until - largest, until});
  std::vector<double> changes;
  const auto change = [&](Exchange& from) {
    for (int i = 0; i < topology_.size(); ++i)
      read.note(from.inputs(i, run_.t_start_, run_.t_start_ + run_.own_step(i), until));
    return read.change();
  };
  change(*run_.exchange_);
  for (int& count = run_.start_passes_; count < passes;) {
    Exchange before = std::move(*run_.exchange_);
    if (count++ > 0) {
      before.reach_back();
      changes.push_back(change(before));
    }
    open_exchange(std::vector<int>(run_.own_steps_.size()));
    for (int i = 0; i < topology_.size(); ++i) pass(i, before, until);
    if (jumped()) return give_up("an output jumps within the first steps, where none may be run again");
  }
  changes.push_back(change(*run_.exchange_));
  if (!settled(changes, round))
    return give_up("the passes of a repeated start do not settle: the last of " + std::to_string(passes) +
                   " changed what is read by " + number_text(changes.back() / changes.front(), 2) +
                   " of what the first did; allowed is 0.1, and less than before");
  if (run_.coordination_.pauses) seed_from_passes();
  set_passes_apart();
}

/// Of a repeated start.
RunStart::FirstSteps RunStart::first_steps() const {
  int degree = 0, samples = 0;
  for (const Line& line : topology_.lines())
    if (line.how.follows_samples()) {
      degree = std::max(degree, line.how.polynomial_degree());
      samples = std::max(samples, line.how.samples());
    }
  const double largest = *std::max_element(run_.own_steps_.begin(), run_.own_steps_.end());
  const int round = 1 + longest_feedthrough(topology_);
  return {(degree + 1) * round, round,
          std::min(run_.t_start_ + samples * (largest + rounding() / 6.0), run_.t_stop_), largest};
}

bool RunStart::jumped() const {
  for (int i = 0; i < topology_.size(); ++i) {
    const History& history = run_.exchange_->history(i);
    for (std::int64_t row = history.oldest(); row <= history.newest(); ++row)
      if (history.jump(row)) return true;
  }
  return false;
}

/// All stand at the start again, as they did before the first pass.
void RunStart::give_up(const std::string& why) {
  note_cold(why);
  run_.start_ = StartKind::cold;
  open_exchange(std::vector<int>(run_.own_steps_.size()));
  for (int i = 0; i < topology_.size(); ++i) run_.stand(i, start_again(i));
  set_passes_apart();
}

void RunStart::set_passes_apart() {
  for (auto& seat : run_.seats_) {
    seat.effort.start_steps = std::exchange(seat.effort.steps, 0);
    seat.effort.exchanges = 0;
  }
}

Clock RunStart::start_again(int who) {
  const auto i = static_cast<std::size_t>(who);
  std::vector<double> memory(static_cast<std::size_t>(topology_.info(who).row_size()));
  Samples first(memory.data(), topology_.info(who).row_size(), 1);
  return named(topology_.name(who), [&] {
    return run_.seats_[i].subsystem->initialize(run_.t_start_, run_.t_stop_, u0_[i], first);
  });
}

/// The subsystem starts again and goes to its last own node at or before `until`, step by step, on the
/// signals of `before`; one with events that others read goes all the way, as they may stand further than its
/// last node.
void RunStart::pass(int who, Exchange& before, double until) {
  const Member& member = run_.schedule_->member(who);
  run_.stand(who, start_again(who));
  while (!run_.tolerance_.before(until, member.next)) {
    const bool land =
        member.lands && !run_.tolerance_.before(member.next, std::min(member.landing, run_.t_stop_));
    run_.take({who, member.next, land}, before);
  }
  if (member.events && run_.time(who) < until - rounding()) run_.take({who, until, true}, before);
  run_.exchange_->commit(who, until);
}

}  // namespace tandem
