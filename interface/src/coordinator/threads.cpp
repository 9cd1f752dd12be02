// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Calls of a round that other threads make.
#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "../seconds_now.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

constexpr double worth = 2e-6;  // s: to hand over a shorter call takes longer than it saves

}  // namespace

void Coordinator::begin_threads() {
  if (coordination_.threads < 1)
    throw Error(ErrorCode::invalid_argument,
                "a run has " + std::to_string(coordination_.threads) + " threads; allowed is 1 or more");
  if (coordination_.threads == 1) return;
  offered_.resize(seats_.size());
  for (std::size_t i = 0; i < seats_.size(); ++i) offered_[i].may_be = !seats_[i].subsystem->one_thread();
  try {
    threads_ = std::make_unique<ThreadPool>(coordination_.threads, topology_.size(),
                                            [this](int who) { make_offered(who); });
  } catch (const std::system_error& error) {
    throw Error(ErrorCode::internal, std::to_string(coordination_.threads) +
                                         " threads can't be started: " + error.code().message());
  }
}

/// Whether one of these calls lasts long enough.
bool Coordinator::is_work_for_threads(std::span<const Turn> turns) const {
  return threads_ && std::any_of(turns.begin(), turns.end(), [this](const Turn& turn) {
           return offered_[static_cast<std::size_t>(turn.who)].seconds >= worth;
         });
}

/// If it lasts long enough.
void Coordinator::offer(const Turn& turn) {
  OfferedCall& offered = offered_[static_cast<std::size_t>(turn.who)];
  if (!offered.may_be || offered.seconds < worth) return;
  offered.turn = turn;
  seat(turn.who).call = Seat::Call::offered;
  threads_->offer(turn.who);
}

/// In any thread. Nobody else is at this subsystem, its inputs or its rows until the call is finished.
void Coordinator::make_offered(int who) {
  OfferedCall& offered = offered_[static_cast<std::size_t>(who)];
  const auto [_, limit, land] = offered.turn;
  const double begin = seconds_now();
  try {
    offered.clock = seat(who).subsystem->advance(limit, land, seat(who).u, exchange_->history(who).room());
  } catch (...) {
    offered.error = std::current_exception();
  }
  note_seconds(who, seconds_now() - begin);
}

Clock Coordinator::finish_offered(int who) {
  threads_->finish(who);
  OfferedCall& offered = offered_[static_cast<std::size_t>(who)];
  if (offered.error) std::rethrow_exception(std::exchange(offered.error, nullptr));
  return offered.clock;
}

/// Of one call.
void Coordinator::note_seconds(int who, double seconds) {
  if (coordination_.profile) seat(who).effort.seconds += seconds;
  if (offered_.empty()) return;
  double& about = offered_[static_cast<std::size_t>(who)].seconds;
  about += about == 0.0 ? seconds : (seconds - about) / 4.0;
}

}  // namespace tandem
