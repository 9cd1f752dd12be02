// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "tandem/coordinator/topology.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

/// Depth-first search over scalar inputs: an input leads to every input that its subsystem's outputs reach at
/// once.
class LoopSearch {
 public:
  explicit LoopSearch(const Topology& topology) : topology_(topology) {
    for (int i = 0; i < topology.size(); ++i) {
      const SubsystemInfo& info = topology.info(i);
      state_.emplace_back(static_cast<std::size_t>(info.input_size()), State::unseen);
      fed_.emplace_back(state_.back().size());
      for (const Feedthrough& f : info.feedthrough)
        fed_.back()[static_cast<std::size_t>(f.input)].push_back(f.output);
      lines_.emplace_back(static_cast<std::size_t>(info.output_size()));
    }
    for (const Line& line : topology.lines())
      if (topology.at_once(line))
        lines_[static_cast<std::size_t>(line.source)][static_cast<std::size_t>(line.output)].push_back(&line);
  }
  /// Texts of the ports along a loop, the first one again at the end; empty if there is none.
  std::vector<std::string> find() {
    for (int i = 0; i < topology_.size(); ++i)
      for (int k = 0; k < topology_.info(i).input_size(); ++k)
        if (visit(i, k)) return cycle();
    return {};
  }

 private:
  enum class State { unseen, open, done };
  struct Step {
    int instance, input, output;
  };

  bool visit(int instance, int input) {
    const auto i = static_cast<std::size_t>(instance), k = static_cast<std::size_t>(input);
    State& state = state_[i][k];
    if (state == State::done) return false;
    path_.push_back({instance, input, -1});
    if (state == State::open) return true;
    state = State::open;
    for (const int output : fed_[i][k]) {
      path_.back().output = output;
      for (const Line* line : lines_[i][static_cast<std::size_t>(output)])
        if (visit(line->reader, line->input)) return true;
    }
    path_.pop_back();
    state = State::done;
    return false;
  }

  std::vector<std::string> cycle() const {
    const Step last = path_.back();
    const auto first = std::find_if(path_.begin(), path_.end(), [&](const Step& s) {
      return s.instance == last.instance && s.input == last.input;
    });
    std::vector<std::string> names;
    for (auto s = first; s != path_.end() - 1; ++s) {
      names.push_back(topology_.input_name(s->instance, s->input));
      names.push_back(topology_.output_name(s->instance, s->output));
    }
    names.push_back(names.front());
    return names;
  }

  const Topology& topology_;
  template <class T>
  using ByScalar = std::vector<std::vector<T>>;  ///< of each instance
  ByScalar<State> state_;
  ByScalar<std::vector<int>> fed_;            ///< outputs that follow an input at once
  ByScalar<std::vector<const Line*>> lines_;  ///< at once, by output
  std::vector<Step> path_;
};

}  // namespace

bool Topology::at_once(const Line& line) const {
  const bool from_sampled = info(line.source).abilities.sampled;
  if (line.lag != Lag::none || (from_sampled && info(line.source).sampling.latency > 0.0)) return false;
  return from_sampled || !info(line.reader).abilities.sampled;
}

void Topology::check_loops() const {
  const auto cycle = LoopSearch(*this).find();
  if (cycle.empty()) return;
  std::string text;
  for (const std::string& name : cycle) text += (text.empty() ? "" : " -> ") + name;
  throw Error(ErrorCode::invalid_argument,
              "algebraic loop over direct feedthrough: " + text +
                  "; break it with memory = true or delay = true on one of its connections");
}

}  // namespace tandem
