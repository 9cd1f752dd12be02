// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_timing.hpp"

#include <algorithm>

#include "bench/heap.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

constexpr int enough_turns = 3;
constexpr double slow = 0.5;  // [s] of timing; then it has had its turns

double heap() { return static_cast<double>(heap_bytes().value_or(0)); }

long timed_steps(const mbs::Mechanism& linkage) {
  return std::clamp(100'000 / linkage.structure().variables, 20, 800);
}

/// One solver's turns.
class Timing {
 public:
  Timing(const LinkageCase& c, mbs::Mechanism& linkage, LinkageOutcome& outcome)
      : linkage_(linkage), outcome_(outcome) {
    guarded([&] {
      const double before = heap();
      run_ = std::make_unique<LinkageRun>(c, linkage);
      run_->steps(1);
      outcome_.stepper_bytes = heap() - before;
    });
  }

  bool wants_more() const { return run_ && spent_ < (turns_ < enough_turns ? slow : timing_patience); }
  void take_turn() {
    guarded([&] {
      const long count = timed_steps(linkage_);
      run_->begin();
      const double seconds = run_->steps(count);
      spent_ += seconds;
      ++turns_;
      outcome_.timed = true;
      outcome_.seconds = std::min(outcome_.seconds, seconds / static_cast<double>(count));
      outcome_.iterations = run_->iterations();
    });
  }

 private:
  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (const Error& error) {
      outcome_.failure = error.what();
      run_ = nullptr;
    }
  }

  mbs::Mechanism& linkage_;
  LinkageOutcome& outcome_;
  std::unique_ptr<LinkageRun> run_;
  double spent_ = 0.0;
  int turns_ = 0;
};

}  // namespace

void time_cases(const std::vector<LinkageCase>& cases, LinkageOutcomes& outcomes) {
  const double before = heap();
  mbs::Mechanism linkage(mbs::read_mechanism("four_bar", four_bar::text(cases.front().loops)));
  const double bytes = heap() - before;
  std::vector<Timing> timings;
  for (const LinkageCase& c : cases) {
    outcomes[c].mechanism_bytes = bytes;
    timings.emplace_back(c, linkage, outcomes[c]);
  }
  for (bool more = true; more;) {
    more = false;
    for (Timing& timing : timings)
      if (timing.wants_more()) {
        timing.take_turn();
        more = true;
      }
  }
}

}  // namespace tandem::bench
