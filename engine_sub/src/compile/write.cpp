// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "write.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "courses.hpp"
#include "instants.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

/// Gives slots their places in the image and writes the program.
class Writer {
 public:
  Writer(Lowering& lowered, const std::vector<int>& outputs, const LoopSettings& loops)
      : d_(lowered),
        loops_(loops),
        outputs_(outputs),
        alive_(alive(d_, outputs)),
        place_(d_.signals.size(), -1) {}

  Program write() {
    for (const auto& [name, value] : loops_.guess)
      guesses_[d_.resolved(d_.named(name, loops_.where))] = value;
    place(Slot::Kind::state);
    leave_room();
    for (const auto kind : {Slot::Kind::time, Slot::Kind::input, Slot::Kind::held, Slot::Kind::result,
                            Slot::Kind::constant, Slot::Kind::past})
      place(kind);
    write_states();
    write_operations();
    write_events();
    find_left_out();
    for (const int output : outputs_) program_.outputs.push_back(at(output));
    write_courses();
    write_feedthrough();
    program_.parameters = d_.parameters;
    program_.curves = d_.curves;
    program_.surfaces = d_.surfaces;
    program_.data = d_.series;
    program_.calls = d_.calls;
    program_.places = d_.places;
    write_delays();
    program_.breaks = d_.breaks;
    std::sort(program_.breaks.begin(), program_.breaks.end());
    place_memory();
    return std::move(program_);
  }

 private:
  int at(int slot) const { return place_[d_.resolved(slot)]; }

  /// Time and inputs are there, needed or not.
  void place(Slot::Kind kind) {
    const bool always = kind == Slot::Kind::time || kind == Slot::Kind::input;
    for (std::size_t s = 0; s < d_.signals.size(); ++s)
      if (d_.signals[s].kind == kind && (always || alive_[s])) {
        place_[s] = static_cast<int>(program_.image.size());
        program_.image.resize(program_.image.size() + static_cast<std::size_t>(d_.signals[s].size));
        program_.image[place_[s]] = d_.signals[s].start;
        program_.signal_names.push_back(d_.signals[s].name);
        program_.signal_names.resize(program_.image.size());
        program_.signal_blocks.resize(program_.image.size(), d_.signals[s].block);
      }
  }

  /// For six states of a reaction for each input, or output.
  void leave_room() {
    const auto inputs = std::count_if(d_.signals.begin(), d_.signals.end(),
                                      [](const Slot& s) { return s.kind == Slot::Kind::input; });
    program_.image.resize(program_.image.size() + 6 * std::min<std::size_t>(inputs, outputs_.size()));
    program_.signal_names.resize(program_.image.size());
    program_.signal_blocks.resize(program_.image.size());
  }

  void write_states() {
    program_.time = place_[0];
    for (std::size_t s = 0; s < d_.signals.size(); ++s) {
      if (d_.signals[s].kind == Slot::Kind::input) program_.inputs.push_back(place_[s]);
      if (d_.signals[s].kind != Slot::Kind::state || place_[s] < 0) continue;
      program_.rates.push_back(at(d_.signals[s].rate));
      program_.state_names.push_back(d_.signals[s].name);
    }
    program_.states = static_cast<int>(program_.rates.size());
  }

  /// First those that rates need, then what else is needed at each step, last what is needed at events.
  void write_operations() {
    std::vector<int> rates;
    for (std::size_t s = 0; s < d_.signals.size(); ++s)
      if (d_.signals[s].kind == Slot::Kind::state && alive_[s]) rates.push_back(d_.signals[s].rate);
    std::vector<int> seen = rates;
    seen.insert(seen.end(), outputs_.begin(), outputs_.end());
    for (const Event& e : d_.events)
      if (e.signal >= 0 && alive_[d_.resolved(e.signal)]) seen.push_back(e.signal);
    for (const Delay& delay : d_.delays)
      if (alive_[delay.past]) seen.push_back(delay.from);
    const auto first = needed_at_once(d_, rates), second = needed_at_once(d_, seen);
    order_ = sorted_steps(d_, alive_, loops_);
    for (const int part : {0, 1, 2}) {
      for (const Sequence& sequence : order_) {
        const int slot = d_.steps[sequence.steps[0]].out;
        if (part == (first[slot] ? 0 : second[slot] ? 1 : 2)) write(sequence);
      }
      if (part == 0) program_.rate_operations = static_cast<int>(program_.operations.size());
      if (part == 1) program_.step_operations = static_cast<int>(program_.operations.size());
    }
  }

  void write(const Sequence& sequence) {
    const auto begin = static_cast<int>(program_.operations.size());
    for (const int step : sequence.steps) write(d_.steps[step]);
    if (sequence.cuts.empty()) return;
    std::vector<int> cuts;
    for (const int slot : sequence.cuts) {
      cuts.push_back(at(slot));
      const auto guess = guesses_.find(d_.resolved(slot));
      if (guess != guesses_.end()) program_.image[cuts.back()] = guess->second;
    }
    cuts_.push_back(sequence.cuts);
    program_.loops.push_back({begin, static_cast<int>(program_.operations.size()), std::move(cuts),
                              listed(blocks_of(d_, sequence.steps)), loops_});
  }

  /// A sum that is one of its own terms reads itself before it is written.
  void read_itself_first(Step& step) {
    bool is_first = false;
    for (std::size_t k = 1; k < step.operations.size(); ++k) {
      Operation &o = step.operations[k], &first = step.operations[0];
      if (o.code != Operation::Code::add || d_.resolved(o.a) != step.out) continue;
      double &factor = d_.parameters[o.parameter], &own = d_.parameters[first.parameter];
      if (!is_first)
        std::swap(o.a, first.a), std::swap(factor, own);
      else
        own += std::exchange(factor, 0.0);
      is_first = true;
    }
  }

  void write(Step step) {
    read_itself_first(step);
    for (Operation o : step.operations) {
      o.out = place_[step.out];
      for (int* const slot : slots_of(o)) *slot = at(*slot);
      program_.operations.push_back(o);
    }
  }

  /// The last loop from which a signal follows at once; -1: none.
  int loop_before(int signal) const {
    if (cuts_.empty()) return -1;
    const auto needed = needed_at_once(d_, {signal});
    for (auto k = static_cast<int>(cuts_.size()) - 1; k >= 0; --k)
      if (std::any_of(cuts_[k].begin(), cuts_[k].end(), [&](int cut) { return needed[cut]; })) return k;
    return -1;
  }

  std::vector<Update> moved(const std::vector<Update>& updates) const {
    std::vector<Update> all;
    for (const Update& u : updates)
      if (alive_[d_.resolved(u.to)]) all.push_back({at(u.to), at(u.from)});
    return all;
  }

  void write_events() {
    for (const DataJumps& jumps : d_.data_jumps)
      if (alive_[d_.resolved(jumps.run)])
        program_.data_jumps.push_back({jumps.data, at(jumps.run), jumps.name});
    for (const Event& e : d_.events) {
      auto updates = moved(e.updates);
      if (updates.empty() && e.bound < 0) continue;
      if (e.kind == Event::Kind::own_step)
        program_.step_updates.insert(program_.step_updates.end(), updates.begin(), updates.end());
      else if (e.kind == Event::Kind::crossing)
        program_.crossings.push_back({at(e.signal), at(e.sign), e.direction, std::move(updates), e.block,
                                      e.sees_start, e.repeats, e.bound, loop_before(e.signal)});
      else
        program_.periodics.push_back({e.period, e.offset, at(e.sign), std::move(updates), e.block});
    }
    for (const auto& [user, range] : d_.guards)
      if (alive_[d_.resolved(user)])
        program_.ranges.push_back(range), program_.ranges.back().signal = at(range.signal);
    program_.bounds = d_.bounds;
    program_.settled = moved(d_.settled);
    program_.starts = moved(d_.starts);
  }

  /// Operations know them by their number among all; those that nothing reads take no part.
  void write_delays() {
    program_.delays = d_.delays;
    for (Delay& delay : program_.delays) {
      const bool is_alive = alive_[delay.past];
      delay.past = is_alive ? place_[delay.past] : -1;
      delay.from = is_alive ? at(delay.from) : -1;
    }
  }

  void write_courses() {
    const Courses courses(d_, order_);
    const bool sampled = courses.sampled(outputs_, alive_);
    for (const int output : outputs_)
      program_.courses.push_back(
          {courses.held(output) && (sampled || courses.jumps(output)), courses.jumps(output)});
    const auto is_state = [this](int slot) { return slot < program_.states; };
    if (std::any_of(program_.outputs.begin(), program_.outputs.end(), is_state))
      for (const int slot : program_.outputs)
        program_.output_rates.push_back(is_state(slot) ? program_.rates[slot] : -1);
    if (sampled) program_.shortest_period = shortest_period(program_);
  }

  /// What is remembered of a run itself.
  void place_memory() {
    const auto slots = [this](std::initializer_list<double> values) {
      program_.image.insert(program_.image.end(), values);
      return static_cast<int>(program_.image.size() - values.size());
    };
    program_.step_begun = slots({0.0});
    program_.events = slots({0.0});
    program_.longest_step = slots({0.0});
    program_.sizes = static_cast<int>(program_.image.size());
    program_.image.resize(program_.image.size() + outputs_.size());
    for (Crossing& c : program_.crossings)
      if (std::any_of(c.updates.begin(), c.updates.end(),
                      [this](const Update& u) { return u.to < program_.states; }))
        c.turn = slots({-std::numeric_limits<double>::infinity(), 0.0});
    program_.signal_names.resize(program_.image.size());
    program_.signal_blocks.resize(program_.image.size());
  }

  void write_feedthrough() {
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      const auto needed =
          program_.sampled() ? needed_at_instant(d_, outputs_[k]) : needed_at_once(d_, {outputs_[k]});
      for (std::size_t s = 0, input = 0; s < d_.signals.size(); ++s)
        if (d_.signals[s].kind == Slot::Kind::input) {
          if (needed[s]) program_.feedthrough.emplace_back(static_cast<int>(k), static_cast<int>(input));
          ++input;
        }
    }
  }

  void find_left_out() {
    std::set<std::string> used;
    for (std::size_t s = 0; s < d_.signals.size(); ++s)
      if (alive_[s]) used.insert(d_.signals[s].block), used.insert(block_of(static_cast<int>(s)));
    for (const std::string& block : d_.blocks)
      if (used.count(block) == 0) program_.left_out.push_back(block);
  }
  std::string block_of(int slot) const { return d_.signals[d_.resolved(slot)].block; }

  Lowering& d_;
  const LoopSettings& loops_;
  std::map<int, double> guesses_;  ///< by resolved slot
  std::vector<int> outputs_;
  std::vector<bool> alive_;
  std::vector<int> place_;
  std::vector<Sequence> order_;
  std::vector<std::vector<int>> cuts_;  ///< of each loop
  Program program_;
};

}  // namespace

Program write_program(Lowering& lowered, const std::vector<int>& outputs, const LoopSettings& loops) {
  return Writer(lowered, outputs, loops).write();
}

}  // namespace tandem::engine
