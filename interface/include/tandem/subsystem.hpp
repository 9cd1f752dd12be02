// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tandem/samples.hpp"
#include "tandem/signal.hpp"
#include "tandem/subsystem_info.hpp"

namespace tandem {

/// Why a call returned.
enum class Stop {
  limit = TANDEM_STOP_LIMIT,                ///< the next own step would end beyond t_limit
  event = TANDEM_STOP_EVENT,                ///< early, at an event; it goes on when called again
  samples_full = TANDEM_STOP_SAMPLES_FULL,  ///< early, no room for another row; it goes on when called again
  finished = TANDEM_STOP_FINISHED,          ///< it will not go on, whatever the limit
};

/// Where a subsystem stands [s], where its next own step would end (later than time), and why it returned.
struct Clock {
  double time, next_time;
  Stop stop;
};

/// What a sampled subsystem is to do at an instant.
enum class SamplePart {
  outputs = TANDEM_SAMPLE_OUTPUTS,  ///< give its outputs; nothing else changes, and it may be asked again
  states = TANDEM_SAMPLE_STATES,    ///< go on to the next instant
  both = TANDEM_SAMPLE_OUTPUTS | TANDEM_SAMPLE_STATES,  ///< the outputs first
};

using StateId = std::int64_t;

/// A count with its name, "rate_evaluations".
struct Figure {
  std::string name;
  std::int64_t count;
};

/// A system that integrates itself with its own step, or a sampled one. One instance is called by one thread
/// at a time, though not always by the same, and others of the same kind by other threads meanwhile; in the
/// order initialize (again, as often as needed), then advance, advance, ... or sample,
/// sample, ... Any call may throw Error; the run ends then.
class Subsystem {
 public:
  virtual ~Subsystem() = default;

  /// Constant after construction.
  virtual const SubsystemInfo& info() const = 0;

  /// Whether all calls have to come from the thread that made it. The base class says false.
  virtual bool one_thread() const;

  /// After initialize(): sentences on what a user of a run to t_stop [s] should know. The base class has
  /// none.
  virtual std::vector<std::string> remarks(double t_stop) const;

  /// What its integrator has done since construction. The base class tells nothing.
  virtual std::vector<Figure> figures() const;

  /// Puts the state at t_start [s] and appends the first sample; the run ends at t_stop [s], past which no
  /// step is asked for. A sampled subsystem gives the outputs that hold before its first instant, which is
  /// its next_time, t_start or later. u0: one value per scalar input, NaN where it is not known yet; an
  /// output without feedthrough from an unknown input must come back finite all the same. May be called again
  /// before the first advance, and afterwards with the ability `restarts`. u0, y and later u belong to the
  /// caller and are valid during the call.
  virtual Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) = 0;

  /// Takes own steps for as long as they end at or before t_limit (tolerant: TimeGrid::fits) and appends one
  /// sample for each, with the outputs after the step. u: one signal per scalar input, covering [time,
  /// t_limit]. May stop early, never passes t_limit. land: the last step is cut so that it ends at t_limit
  /// (only with the ability `lands`); the grid of own steps stays as it was.
  virtual Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) = 0;

  /// `advance` in two halves, so that several subsystems can be at work at the same time (one behind a socket
  /// sends its request in the first and awaits the reply in the second). True: the call is under way; no
  /// other call may come before finish_advance, and u and y's rows stay as they are until then. False: it is
  /// not; call advance. The base class says false, and is never asked to finish.
  virtual bool start_advance(double t_limit, bool land, std::span<const Signal> u, const Samples& y);
  virtual Clock finish_advance(Samples& y);

  /// With the ability `sampled`, in place of advance: acts at the instant t [s], its next_time. u: one value
  /// per scalar input at t, of other sampled subsystems with what is new at t; for the states it is as for
  /// the outputs, but for inputs that do not feed through. y: one value per scalar output, to be given with
  /// the outputs; they hold from t + latency until the next ones do. Returns where it stands and its next
  /// instant (of the outputs alone it is not looked at). The base class refuses with Error(not_supported).
  virtual Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y);

  /// With the ability `saves_state`: a copy of the whole state, valid until released. The base class refuses
  /// all three with Error(not_supported); an id that is not saved is Error(invalid_argument).
  virtual StateId save_state();
  /// Stands again where it stood when `id` was saved; `id` stays saved.
  virtual Clock restore_state(StateId id);
  virtual void release_state(StateId id);

  /// With the ability `serializes_state`, beside `saves_state`: a saved state as bytes, and from bytes a
  /// saved state. They are for an instance that is made with the same parameters and initialized with the
  /// same span and inputs, in this process or another; restored there, it goes on with the same bits as this
  /// one does. With this ability save_state leaves what follows as it would be without it. Bytes of another
  /// subsystem, or not whole, are Error(invalid_argument), where that can be told. The base class refuses
  /// both.
  virtual std::vector<std::byte> serialize_state(StateId id);
  virtual StateId deserialize_state(std::span<const std::byte> bytes);
};

}  // namespace tandem
