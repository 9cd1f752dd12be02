// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <span>
#include <vector>

#include "tandem/coordinator/coordination.hpp"
#include "tandem/subsystem.hpp"

namespace tandem {

/// What a coordinator knows of one subsystem, beside the schedule and the exchange.
struct alignas(64) Seat {
  /// How far its next call is: not begun, failed, its inputs are there, begun by the subsystem itself,
  /// offered to other threads.
  enum class Call : std::uint8_t { none, failed, prepared, under_way, offered };

  Subsystem* subsystem;
  double time = 0.0;               ///< where it stands [s]
  std::int64_t batch = 0;          ///< own steps that a call may take
  std::int64_t rows = 0;           ///< that there were before the call that has begun
  std::span<const Signal> u = {};  ///< of a call that has begun
  int idle_calls = 0;              ///< since it last moved
  Stop stop = Stop::limit;         ///< why its last call returned
  Call call = Call::none;
  bool works_here = false;  ///< begins no call by itself (Subsystem::start_advance)
  bool goes_back = false;   ///< to events that it has passed
  Effort effort = {};
  std::int64_t told = 0;  ///< last row that the observer knows
};

/// A call that another thread may make.
struct OfferedCall {
  bool may_be = true;    ///< offered at all
  double seconds = 0.0;  ///< that a call lasts, about
  Turn turn = {};
  Clock clock = {};
  std::exception_ptr error = {};
};

/// One that a subsystem reads, whose outputs jump with its inputs.
struct Through {
  int source;
  bool at_once;  ///< outputs of the subsystem follow what it reads of it
};

/// What a coordinator knows of the events of one subsystem, and of those that it reads.
struct EventSeat {
  /// A state that one may go back to, at the newest row of then.
  struct Back {
    static constexpr StateId none = -1;
    StateId state = none;
    double time = 0.0;
    std::int64_t row = 0;
  };
  std::vector<int> readers = {};   ///< Of one with events: who integrates itself and reads it, or a carrier.
  std::vector<int> carriers = {};  ///< Whose outputs jump with its at once, by however many others.
  std::vector<int> of_carriers = {};   ///< Of the readers those of carriers.
  std::vector<int> leaders_back = {};  ///< Of these who may go back.
  /// Of one that may go back: those with events that it reads and leads.
  std::vector<int> events_behind = {};
  std::vector<Back> back = {};  ///< Of such a one, the oldest first.
  std::int64_t times_back = 0;
  // Events that a reader had passed, and did not go back to.
  std::int64_t missed = 0;
  double most_missed = 0.0;  ///< Jump times how far it had passed.
  int missed_by = -1;        ///< Where that was.
};

/// Of several pieces of work that are all done, the error of the first that failed, by their numbers.
class FirstError {
 public:
  template <class Work>
  void of(std::size_t number, const Work& work) try {
    work();
  } catch (...) {
    if (number < number_) number_ = number, error_ = std::current_exception();
  }
  void raise() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::size_t number_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr error_;
};

}  // namespace tandem
