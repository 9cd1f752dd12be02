// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tandem/samples.hpp"
#include "tandem/signal.hpp"

namespace tandem {

/// An input or output. An array port has size > 1; its scalars follow one another in the flattened numbering.
struct Port {
  std::string name;
  std::string unit;     ///< "1" for none; SI unless it says otherwise ("rpm")
  int size = 1;         ///< number of scalars
  int derivatives = 0;  ///< of an output: time derivatives given with each sample, 0 to 3
  double start =
      std::numeric_limits<double>::quiet_NaN();  ///< of an input: its value when nothing else is known
};

/// Which port a scalar of the flattened numbering belongs to.
struct Scalar {
  const Port* port;
  int element;
  std::string name() const;  ///< "x" or, of an array port, "x[2]"
};
/// Precondition: 0 <= index < the number of scalars.
Scalar scalar_at(const std::vector<Port>& ports, int index);

/// The scalar output at time t depends on that scalar input at the same t (flattened indices).
struct Feedthrough {
  int output, input;
};

/// What a subsystem can do beyond the least.
struct Abilities {
  bool chooses_step = false;  ///< own steps vary
  bool lands = false;         ///< can cut a step so that it ends at t_limit
  bool saves_state = false;
  bool restarts = false;  ///< may be initialized again after an advance
  bool reactive_inputs = false;
  bool serializes_state = false;  ///< gives saved states as bytes, and takes them
};
/// The same as bits of subsystem.h (TANDEM_LANDS, ...); bits that are not known are left out.
std::uint32_t to_bits(const Abilities& abilities);
Abilities abilities_from(std::uint32_t bits);

struct SubsystemInfo {
  std::string name;
  std::vector<Port> inputs, outputs;
  std::vector<Feedthrough> feedthrough;
  Abilities abilities;

  int input_size() const { return scalars(inputs); }    ///< number of scalar inputs
  int output_size() const { return scalars(outputs); }  ///< number of scalar outputs
  int derivatives() const {                             ///< blocks of derivatives in a sample row
    int most = 0;
    for (const Port& port : outputs) most = port.derivatives > most ? port.derivatives : most;
    return most;
  }
  /// Doubles in a sample row.
  std::int64_t row_size() const {
    return Samples::header + std::int64_t{output_size()} * (1 + derivatives());
  }

 private:
  static int scalars(const std::vector<Port>& ports) {
    int sum = 0;
    for (const Port& port : ports) sum += port.size;
    return sum;
  }
};

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

using StateId = std::int64_t;

/// A system that integrates itself with its own step. One instance is called by one thread at a time, in the
/// order initialize (again, as often as needed), advance, advance, ... Any call may throw Error; the run ends
/// then.
class Subsystem {
 public:
  virtual ~Subsystem() = default;

  /// Constant after construction.
  virtual const SubsystemInfo& info() const = 0;

  /// Puts the state at t_start [s] and appends the first sample; the run ends at t_stop [s], past which no
  /// step is asked for. u0: one value per scalar input, NaN where it is not known yet; an output without
  /// feedthrough from an unknown input must come back finite all the same. May be called again before the
  /// first advance, and afterwards with the ability `restarts`. u0, y and later u belong to the caller and
  /// are valid during the call.
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
