// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "refuse.hpp"
#include "sort.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

/// Visits the steps of one loop in depth, so that each comes after what it reads, but for what is read while
/// it is being made: there the loop is cut. Signals with a guess are cut first.
class Cutter {
 public:
  Cutter(const Lowering& d, const std::vector<int>& maker, const std::vector<int>& members)
      : d_(d), maker_(maker), state_(d.steps.size(), State::elsewhere) {
    for (const int step : members) state_[step] = State::unseen;
  }

  void cut(int slot) {
    if (std::find(sequence.cuts.begin(), sequence.cuts.end(), slot) == sequence.cuts.end())
      sequence.cuts.push_back(slot);
  }
  bool has(int slot) const { return maker_[slot] >= 0 && state_[maker_[slot]] != State::elsewhere; }

  void visit(int step) {
    if (state_[step] != State::unseen) return;
    state_[step] = State::open;
    for (const int from : needed_by(d_, d_.steps[step])) read(from);
    state_[step] = State::done;
    sequence.steps.push_back(step);
  }

  Sequence sequence;

 private:
  enum class State { elsewhere, unseen, open, done };

  void read(int slot) {
    if (!has(slot) || std::find(sequence.cuts.begin(), sequence.cuts.end(), slot) != sequence.cuts.end())
      return;
    state_[maker_[slot]] == State::open ? cut(slot) : visit(maker_[slot]);
  }

  const Lowering& d_;
  const std::vector<int>& maker_;
  std::vector<State> state_;
};

/// Strongly connected steps, each such group after those that it reads (R. Tarjan, SIAM J. Comput. 1 (1972)
/// 146).
class Groups {
 public:
  explicit Groups(const Lowering& d)
      : d_(d), maker_(makers(d)), number_(d.steps.size()), low_(d.steps.size()) {}

  void visit(int step) {
    if (number_[step] > 0) return;
    number_[step] = low_[step] = ++count_;
    stack_.push_back(step);
    bool reads_itself = false;
    for (const int from : needed_by(d_, d_.steps[step])) {
      const int next = maker_[from];
      reads_itself = reads_itself || next == step;
      if (next >= 0) follow(step, next);
    }
    if (low_[step] == number_[step]) close(step, reads_itself);
  }

  struct Group {
    std::vector<int> steps;
    bool is_loop;
  };
  std::vector<Group> groups;
  const std::vector<int>& maker() const { return maker_; }

 private:
  void follow(int step, int next) {
    if (number_[next] == 0) {
      visit(next);
      low_[step] = std::min(low_[step], low_[next]);
    } else if (std::find(stack_.begin(), stack_.end(), next) != stack_.end()) {
      low_[step] = std::min(low_[step], number_[next]);
    }
  }

  void close(int step, bool reads_itself) {
    const auto first = std::find(stack_.begin(), stack_.end(), step);
    groups.push_back({{first, stack_.end()}, reads_itself || stack_.end() - first > 1});
    stack_.erase(first, stack_.end());
  }

  const Lowering& d_;
  std::vector<int> maker_, number_, low_, stack_;
  int count_ = 0;
};

/// A way from a step of a loop back to it, each step reading the one after it.
std::vector<int> circle(const Lowering& d, const std::vector<int>& maker, const std::vector<int>& members) {
  std::vector<int> path = {members.front()};
  while (true) {
    int next = -1;
    for (const int from : needed_by(d, d.steps[path.back()])) {
      const int step = maker[from];
      if (next < 0 && std::find(members.begin(), members.end(), step) != members.end()) next = step;
    }
    const auto seen = std::find(path.begin(), path.end(), next);
    if (seen != path.end()) return {seen, path.end()};
    path.push_back(next);
  }
}

[[noreturn]] void refuse_loop(const Lowering& d, const std::vector<int>& steps) {
  const auto blocks = blocks_of(d, steps);
  const auto place = d.places.find(blocks.front());
  refuse(place == d.places.end() ? "" : place->second,
         "an algebraic loop goes through the blocks " + listed(blocks) +
             ": each depends on the one after it at once; allowed is a loop with an integrator, a lag or a "
             "sample in it, or solve = true in the table [loops]");
}

}  // namespace

std::vector<std::string> blocks_of(const Lowering& d, const std::vector<int>& steps) {
  std::vector<std::string> blocks;
  for (const int step : steps)
    if (std::find(blocks.begin(), blocks.end(), d.steps[step].block) == blocks.end())
      blocks.push_back(d.steps[step].block);
  return blocks;
}

std::vector<Sequence> sorted_steps(const Lowering& d, const std::vector<bool>& wanted,
                                   const LoopSettings& loops) {
  Groups all(d);
  for (std::size_t k = 0; k < d.steps.size(); ++k)
    if (wanted[d.steps[k].out]) all.visit(static_cast<int>(k));
  std::vector<Sequence> order;
  for (const auto& group : all.groups) {
    if (!group.is_loop) {
      order.push_back({group.steps});
      continue;
    }
    if (!loops.solve) refuse_loop(d, circle(d, all.maker(), group.steps));
    Cutter cutter(d, all.maker(), group.steps);
    for (const auto& [name, guess] : loops.guess)
      for (std::size_t s = 0; s < d.signals.size(); ++s) {
        const int slot = d.resolved(static_cast<int>(s));
        if (d.signals[s].name == name && cutter.has(slot)) cutter.cut(slot);
      }
    for (const int step : group.steps) cutter.visit(step);
    order.push_back(std::move(cutter.sequence));
  }
  return order;
}

}  // namespace tandem::engine
