// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/declared_parameters.hpp"
#include "tandem/error.hpp"
#include "tandem/subsystem.hpp"
#include "tandem/wire/frame.hpp"

namespace tandem::wire {

// Payloads. put_...() writes one after begin(); read_...() takes one apart, and refuses what is not exactly
// right with Error(invalid_argument), before it allocates anything that is not there.

/// Bits of the capabilities: its sender speaks of held outputs and of sampled subsystems, of the parameters
/// that a kind declares, of nominal values, of inputs that react. What both sides speak of is told.
constexpr std::uint32_t carries_held = 1, carries_parameters = 2, carries_nominal = 4, carries_reactions = 8,
                        all_capabilities =
                            carries_held | carries_parameters | carries_nominal | carries_reactions;

/// The first request and its reply.
struct Hello {
  std::uint32_t lowest_version = protocol_version, highest_version = protocol_version;
  std::uint64_t longest = usual_longest;          ///< payload that its sender takes, in bytes
  std::uint32_t capabilities = all_capabilities;  ///< bits
  std::string text;  ///< of a request: parameters "key=value&key=value"; of a reply: the software
  std::optional<DeclaredParameters> declared = {};  ///< of a reply where both speak of parameters
};
void put_hello(Writer& frame, const Hello& hello);
/// asked_with: of a reply, the capabilities of the request.
Hello read_hello(std::span<const std::byte> payload, std::uint32_t asked_with = 0);

/// capabilities: of both sides.
void put_info(Writer& frame, const SubsystemInfo& info, std::uint32_t capabilities = all_capabilities);
SubsystemInfo read_info(std::span<const std::byte> payload, std::uint32_t capabilities = all_capabilities);

struct Initialize {
  double t_start = 0.0, t_stop = 0.0;  ///< [s]
  std::uint64_t room = 0;              ///< rows that the reply may have
  std::vector<double> u0;              ///< NaN where a value is not known
};
void put_initialize(Writer& frame, const Initialize& request);
/// Into `request`, whose memory is used again. inputs: scalars that there are.
void read_initialize(std::span<const std::byte> payload, int inputs, Initialize& request);

/// Numbers of a reaction, as it is read: what it points to.
struct ReadReaction {
  std::vector<double> begin;
  std::vector<tandem_reaction_term> terms;
  std::vector<tandem_reaction_course> courses;
  std::vector<tandem_reactive_input> inputs;
  Reaction view = {};
};

/// A request to advance, as it is read: signals are views of the segments, and of the reaction.
struct Advance {
  double t_limit = 0.0;  ///< [s]
  bool land = false;
  std::uint64_t room = 0;  ///< rows that the reply may have
  std::vector<Signal> signals;
  std::vector<Segment> segments;
  ReadReaction reaction;
};
/// How many a subsystem has; with `react` inputs that may react.
struct Scalars {
  int inputs, outputs;
  bool react;
  /// carries: the wire carries reactions.
  static Scalars of(const SubsystemInfo& info, bool carries) {
    return {info.input_size(), info.output_size(), carries && info.abilities.reactive_inputs};
  }
};
/// What the request asks for besides the inputs.
struct Goal {
  double t_limit;
  bool land;
  std::uint64_t room;
};
/// react: of a subsystem with reactive inputs, where both sides speak of them.
void put_advance(Writer& frame, const Goal& goal, std::span<const Signal> inputs, bool react = false);
/// most: bytes of memory that the signals may take.
void read_advance(std::span<const std::byte> payload, const Scalars& scalars, Advance& request,
                  std::uint64_t most = usual_longest);
/// What stands behind the signals of one whose inputs may react.
void put_reaction(Writer& frame, std::span<const Signal> inputs);
void read_reaction(ByteReader& in, const Scalars& scalars, Advance& to);

/// A request to sample: Subsystem::sample.
struct Sample {
  double t = 0.0;  ///< [s]
  SamplePart part = SamplePart::both;
  std::vector<double> u;
};
void put_sample(Writer& frame, double t, SamplePart part, std::span<const double> u);
/// Into `request`, whose memory is used again. inputs: scalars that there are.
void read_sample(std::span<const std::byte> payload, int inputs, Sample& request);
/// Its reply: the outputs that the request asks for; none if it asks for the states alone.
void put_sampled(Writer& frame, const Clock& clock, std::span<const double> y);
/// Fills y, or refuses another number of outputs.
Clock read_sampled(std::span<const std::byte> payload, std::span<double> y);

/// Room in the frame for so many rows, to be filled before put_samples() or put_error() puts them: they stand
/// where the reply has them. Precondition: begin() and nothing since.
Samples room_for_rows(Writer& frame, std::int64_t stride, std::int64_t capacity);
/// The rows of y.
void put_samples(Writer& frame, const Clock& clock, const Samples& y);
/// Appends the rows to y; returns the clock. Error(invalid_argument) too for rows of another size, or more
/// than y has room for.
Clock read_samples(std::span<const std::byte> payload, Samples& y);
constexpr std::uint64_t samples_head = 32;  ///< bytes before the first row

void put_clock(Writer& frame, const Clock& clock);
Clock read_clock(std::span<const std::byte> payload);

void put_id(Writer& frame, StateId id);
StateId read_id(std::span<const std::byte> payload);

/// An error; and with the rows that were appended before it (only those of an advance), or with the
/// parameters that the subsystem's kind declares (only of a hello, where both sides speak of them).
void put_error(Writer& frame, ErrorCode code, std::string_view sentence);
void put_error(Writer& frame, const Error& error, const Samples& y);
void put_error(Writer& frame, const NotMade& error);
/// The error that the other side tells; rows are appended to *y if they fit it, y may be null.
Error read_error(std::span<const std::byte> payload, Samples* y);
/// Likewise, in answer to a hello that spoke of parameters.
Error read_error(std::span<const std::byte> payload, DeclaredParameters& declared);

/// Nothing may be in the payload.
void read_nothing(const Frame& frame);

}  // namespace tandem::wire
