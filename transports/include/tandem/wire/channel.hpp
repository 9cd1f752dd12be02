// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <cstddef>
#include <span>
#include <string>

#include "tandem/wire/frame.hpp"

namespace tandem::wire {

using Deadline = std::chrono::steady_clock::time_point;
/// So many seconds from now; never, if there are too many.
Deadline in_seconds(double seconds);

/// A connection that carries frames in both directions: all that a transport has to be. Used by one thread at
/// a time, except for close().
class Channel {
 public:
  virtual ~Channel() = default;

  /// Sends one whole frame. Throws Error(input_output) if that can't be done by then.
  virtual void send(std::span<const std::byte> frame, Deadline deadline) = 0;
  /// The next frame, whole, valid until the next call; none (empty) if the peer has closed the connection
  /// between two frames. Throws Error(input_output) for what ends within a frame and if there is no whole
  /// frame by then; Error(invalid_argument) for a header that read_header refuses.
  virtual std::span<const std::byte> receive(Deadline deadline) = 0;
  /// The frame that was received last is not needed any more: its memory may go.
  virtual void forget() {}
  /// Payloads that a server takes and gives over it [bytes].
  virtual std::uint64_t longest() const { return usual_longest; }
  /// Waits for the beginning of a frame, or the end of the connection. False: there was none by then.
  virtual bool wait(Deadline deadline) = 0;
  /// Ends the connection; whoever waits in another thread wakes with an error or an empty frame.
  virtual void close() noexcept = 0;
  /// The other end, as errors name it: "tcp://127.0.0.1:4000".
  virtual const std::string& peer() const = 0;
};

}  // namespace tandem::wire
