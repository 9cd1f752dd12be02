// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tandem/linearized.hpp"
#include "tandem/samples.hpp"
#include "tandem/signal.hpp"
#include "tandem/subsystem_info.hpp"

namespace tandem {

class SlowModel;
struct SlowLink;

/// Why a call returned.
enum class Stop {
  limit = TANDEM_STOP_LIMIT,                ///< The next own step would end beyond t_limit.
  event = TANDEM_STOP_EVENT,                ///< Early, at an event; it goes on when called again.
  samples_full = TANDEM_STOP_SAMPLES_FULL,  ///< Early, no room for another row; it goes on when called again.
  finished = TANDEM_STOP_FINISHED,          ///< It will not go on, whatever the limit.
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

/// A system that integrates itself with its own step, or a sampled one. (One file, as it is the whole contract: whoever
/// writes a subsystem reads it from end to end.)
///
/// Order of calls on one instance:
/// 1. The constructor. info() is constant from then on.
/// 2. initialize(), again as often as needed.
/// 3. advance(), advance(), ... or, of a sampled subsystem, sample(), sample(), ...
/// 4. The destructor.
///
/// After the first call of step 3, initialize() may be called again only with the ability `restarts`.
///
/// One thread at a time calls an instance, though not always the same one: see one_thread(). Other threads
/// may call other instances of the same kind meanwhile. Any call may throw Error; the run ends then. u0, u
/// and y belong to the caller and are valid during the call (of start_advance(): until finish_advance()).
class Subsystem {
 public:
  virtual ~Subsystem() = default;

  /// Ports, feedthrough and abilities. Constant after construction.
  virtual const SubsystemInfo& info() const = 0;

  /// Whether all calls have to come from the thread that made it. The base class says false.
  virtual bool one_thread() const;

  /// Sentences on what a user of a run should know. Precondition: initialize() was called. The base class has
  /// none.
  /// - t_stop [s]: the end of the run.
  virtual std::vector<std::string> remarks(double t_stop) const;

  /// What its integrator has done since construction. The base class tells nothing.
  virtual std::vector<Figure> figures() const;

  /// Puts the state at t_start and appends the first sample. An output without feedthrough from an unknown
  /// input must come back finite all the same. A sampled subsystem gives the outputs that hold before its
  /// first instant; that instant is its next_time. Of several calls the sample of the last one counts.
  /// - t_start [s]: the begin of the run. The first instant of a sampled subsystem is t_start or later.
  /// - t_stop [s]: the end of the run. No call asks for a step past it.
  /// - u0: one value per scalar input, in the unit of its port; NaN where it is not known yet.
  /// - y: takes the first sample. Precondition: room for one row of info().row_size() doubles.
  virtual Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) = 0;

  /// Takes own steps for as long as they end at or before t_limit, and appends one sample for each, with the
  /// outputs after the step. It may stop early (Stop) and never passes t_limit.
  /// - t_limit [s]: where the last step ends at the latest. The comparison is tolerant: TimeGrid::fits.
  /// - land: the last step is cut so that it ends at t_limit; the grid of own steps stays as it was.
  ///   Precondition of true: the ability `lands`.
  /// - u: one signal per scalar input, covering [time, t_limit], in the unit of its port. At the begin of a
  ///   call it may differ from what it was at the end of the last one.
  /// - y: takes a row of info().row_size() doubles for each step. Precondition: room for two rows with the
  ///   ability `events`.
  virtual Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) = 0;

  /// The first half of `advance`, so that several subsystems can be at work at the same time. One behind a
  /// socket sends its request here and awaits the reply in finish_advance(). True: the call is under way. No
  /// other call may come before finish_advance(). False: it is not under way; call advance(). The base class
  /// says false.
  /// - t_limit [s]: as for advance().
  /// - land: as for advance().
  /// - u: as for advance(); it stays as it is until finish_advance().
  /// - y: as for advance(); its rows stay as they are until finish_advance().
  virtual bool start_advance(double t_limit, bool land, std::span<const Signal> u, const Samples& y);
  /// The second half. Precondition: start_advance() returned true, so the base class never has to finish.
  /// - y: the same as for start_advance(). It takes the rows.
  virtual Clock finish_advance(Samples& y);

  /// In place of advance(), with the ability `sampled`: acts at an instant. Returns where it stands and its
  /// next instant; after a call for the outputs alone nobody looks at that. The base class refuses with
  /// Error(not_supported).
  /// - t [s]: the instant. Precondition: it is its next_time.
  /// - part: what it is to do.
  /// - u: one value per scalar input at t. Inputs from other sampled subsystems have what is new at t. The
  ///   values for the states are the values for the outputs, but for inputs that do not feed through.
  /// - y: one value per scalar output, to be given with the outputs. They hold from t + latency until the
  ///   next ones do.
  virtual Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y);

  /// The states that get_states() gives, the same after each initialize(). These, the time and its inputs are
  /// all that its next own steps depend on, to a millionth. Precondition: initialize() was called. Nothing:
  /// it keeps them to itself, as the base class does. An empty list: it has none.
  virtual std::optional<std::vector<StateName>> states() const;
  /// What they are where it stands. The base class refuses this and the next one with Error(not_supported).
  /// - x: takes one value per state, in its unit.
  virtual void get_states(std::span<double> x) const;
  /// Puts its states, after initialize() and before the first step: it goes on as if it had come there by
  /// steps. The sample that initialize() gave is not given anew.
  /// - x: one finite value per state, near what they are: where others follow from them in several ways, the
  ///   nearest is meant.
  virtual void set_states(std::span<const double> x);
  /// Its own equations about the states and inputs of initialize(). Precondition: it was called, and no step
  /// was taken since. Nothing: it keeps them to itself, as the base class does.
  virtual std::optional<Linearized> linearized() const;
  /// Its equations, for an impulse coupling by a surrogate in this process. Precondition: initialize() was called.
  /// Null: it keeps them to itself, as the base class does. They go by where it stands, so it is to outlive them.
  /// - links: forces that are its inputs, and displacements that are its outputs.
  virtual std::shared_ptr<SlowModel> slow_model(std::span<const SlowLink> links) const;

  /// With the ability `saves_state`: copies the whole state. The copy is valid until it is released. The base
  /// class refuses this and the next two with Error(not_supported).
  virtual StateId save_state();
  /// Stands again where it stood when the state was saved.
  /// - id: of save_state() or deserialize_state(); it stays saved. Error(invalid_argument) if it is not
  ///   saved.
  virtual Clock restore_state(StateId id);
  /// - id: as for restore_state(); it is not saved any more.
  virtual void release_state(StateId id);

  /// With the ability `serializes_state`, beside `saves_state`: a saved state as bytes. The bytes are for an
  /// instance that is made with the same parameters and initialized with the same span and inputs, in this
  /// process or another. Restored there, it goes on with the same bits as this one does. With this ability
  /// save_state() leaves what follows as it would be without it. The base class refuses this and the next
  /// one.
  /// - id: as for restore_state().
  virtual std::vector<std::byte> serialize_state(StateId id);
  /// A saved state made from bytes.
  /// - bytes: of serialize_state(). Bytes of another subsystem, or not whole, are Error(invalid_argument),
  ///   where that can be told.
  virtual StateId deserialize_state(std::span<const std::byte> bytes);
};

}  // namespace tandem
