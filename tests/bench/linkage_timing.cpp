// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_timing.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "bench/heap.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

constexpr int enough_turns = 3, pieces = 20;
constexpr double slow = 0.5;  // [s] of timing; then it has had its turns

double heap() { return static_cast<double>(heap_bytes().value_or(0)); }

long timed_steps(const mbs::Mechanism& linkage) {
  return std::clamp(100'000 / linkage.structure().variables, 20, 800);
}

/// One solver's turns.
class LinkageTiming {
 public:
  LinkageTiming(const LinkageCase& c, mbs::Mechanism& linkage, LinkageOutcome& outcome)
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
      for (long k = 0; k < pieces; ++k) {
        const double seconds = run_->steps((k + 1) * count / pieces - k * count / pieces);
        spent_ += seconds;
        least_[k] = turns_ == 0 ? seconds : std::min(least_[k], seconds);
      }
      ++turns_;
      outcome_.timed = true;
      outcome_.seconds = std::accumulate(least_.begin(), least_.end(), 0.0) / static_cast<double>(count);
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
  std::array<double, pieces> least_{};  ///< of each piece of the steps: what interrupts one spoils no other
  double spent_ = 0.0;
  int turns_ = 0;
};

}  // namespace

void time_cases(const std::vector<LinkageCase>& cases, LinkageOutcomes& outcomes) {
  const double before = heap();
  mbs::Mechanism linkage(mbs::read_mechanism("four_bar", four_bar::text(cases.front().loops)));
  const double bytes = heap() - before;
  std::vector<LinkageTiming> timings;
  for (const LinkageCase& c : cases) {
    outcomes[c].mechanism_bytes = bytes;
    timings.emplace_back(c, linkage, outcomes[c]);
  }
  for (bool more = true; more;) {
    more = false;
    for (LinkageTiming& timing : timings)
      if (timing.wants_more()) {
        timing.take_turn();
        more = true;
      }
  }
}

}  // namespace tandem::bench
