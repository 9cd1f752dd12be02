// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// How a run ends, and what it tells then.
#include <cmath>

#include "../number_text.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/error.hpp"

namespace tandem {

/// After an error, and at the end: what might have been taken back.
void Coordinator::keep_rest() {
  ended_ = true;
  for (int i = 0; i < topology_.size(); ++i)
    if (seat(i).goes_back) tell(i);
}

/// Of one that ended own steps at the samples of others.
void Coordinator::note_extra_steps(int who) {
  const Abilities& a = topology_.info(who).abilities;
  const double fit = std::ceil((t_stop_ - t_start_) / own_step(who) - 1e-9);
  const auto taken = effort(who).steps;
  if (has_samples_ && !a.sampled && !a.chooses_step && static_cast<double>(taken) > fit)
    notes_.push_back("subsystem '" + topology_.name(who) + "' took " + std::to_string(taken) +
                     " own steps where " + number_text(fit) + " fit, as it ended some at samples of others");
}

/// A schedule without a turn is at its end, or it is wrong: never is that an end in silence.
void Coordinator::check_end() const {
  std::string waiting;
  for (int i = 0; i < topology_.size(); ++i)
    if (const Member& m = schedule_->member(i); !m.finished() && tolerance_.before(m.next, schedule_->stop()))
      waiting += (waiting.empty() ? "subsystem '" : ", '") + topology_.name(i) +
                 "' at t = " + number_text(time(i)) + " s";
  if (!waiting.empty())
    throw Error(ErrorCode::internal,
                "each waits for another: " + waiting + "; no schedule should come to that");
}

bool Coordinator::end() {
  check_end();
  keep_rest();
  note_events();
  for (int i = 0; i < topology_.size(); ++i) note_extra_steps(i);
  for (int i = 0; i < topology_.size(); ++i)
    if (!topology_.info(i).abilities.sampled && tolerance_.before(time(i), t_stop_))
      notes_.push_back("subsystem '" + topology_.name(i) + "' ended at t = " + number_text(time(i)) +
                       " s, its last own node, " + number_text(t_stop_ - time(i), 3) + " s before the end");
  stopped_ = true;
  return false;
}

}  // namespace tandem
