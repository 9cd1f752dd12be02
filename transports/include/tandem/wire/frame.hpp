// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "tandem/wire/bytes.hpp"

/// The protocol of docs/wire_protocol.md: bytes in, values out; no socket is known here.
namespace tandem::wire {

constexpr std::uint32_t protocol_version = 1;
constexpr std::size_t header_size = 16;  ///< bytes
constexpr std::size_t type_place = 8;    ///< of the type in the header
/// Payload that is taken if nothing else is said.
constexpr std::uint64_t usual_longest = std::uint64_t{1} << 26;
constexpr std::uint64_t shortest_limit = 4096;  ///< the least that a peer has to take

enum class Type : std::uint32_t {
  hello = 1,
  info = 2,
  initialize = 3,
  advance = 4,
  samples = 5,
  save = 6,
  restore = 7,
  release = 8,
  ping = 9,
  error = 10,
  bye = 11,
  serialize = 12,
  deserialize = 13,
  sample = 14,
};
constexpr std::uint32_t last_type = 14;
std::string_view name(Type type);

/// What stands before each payload.
struct Header {
  std::uint64_t length = 0;  ///< of the payload, in bytes
  Type type = Type::bye;
  std::uint32_t number = 0;  ///< of the request; its reply has the same
};

/// Precondition: header_size bytes. Throws Error(invalid_argument) for a payload longer than `longest` and
/// for a type that is not known.
Header read_header(std::span<const std::byte> bytes, std::uint64_t longest);

/// A frame of the bytes that a channel received: header and payload, as long as its header says.
struct Frame {
  Header header;
  std::span<const std::byte> payload;

  static Frame read(std::span<const std::byte> bytes, std::uint64_t longest);
};

/// Begins a frame: puts a header whose length finish() fills in.
void begin(Writer& frame, Type type, std::uint32_t number);
void finish(Writer& frame);

}  // namespace tandem::wire
