// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "tandem/wire/channel.hpp"
#include "tandem/wire/frame.hpp"

namespace tandem::tcp {

/// Bytes in both directions.
class Stream {
 public:
  virtual ~Stream() = default;
  /// At least one byte; 0 at the end of the stream; nothing if none came by then. Throws Error(input_output).
  virtual std::optional<std::size_t> read(std::span<std::byte> to, wire::Deadline deadline) = 0;
  /// All of them. Throws Error(input_output), also if they are not taken by then.
  virtual void write(std::span<const std::byte> bytes, wire::Deadline deadline) = 0;
  /// May be called from another thread.
  virtual void shut_down() noexcept = 0;
};

/// Frames over a stream of bytes.
class StreamChannel final : public wire::Channel {
 public:
  StreamChannel(std::unique_ptr<Stream> stream, std::string peer)
      : stream_(std::move(stream)), peer_(std::move(peer)) {}

  void send(std::span<const std::byte> frame, wire::Deadline deadline) override {
    stream_->write(frame, deadline);
  }
  std::span<const std::byte> receive(wire::Deadline deadline) override;
  void forget() override;
  bool wait(wire::Deadline deadline) override;
  void close() noexcept override { stream_->shut_down(); }
  const std::string& peer() const override { return peer_; }

 private:
  std::span<const std::byte> came() const { return {memory_.get(), size_}; }
  std::size_t wanted() const;
  bool fill(wire::Deadline deadline);
  void drop_last();

  std::unique_ptr<Stream> stream_;
  std::string peer_;
  static constexpr std::size_t first_room = 1 << 16, usual_room = 1 << 22;  ///< bytes
  void hold(std::size_t room);

  std::unique_ptr<std::byte[]> memory_ = std::make_unique_for_overwrite<std::byte[]>(first_room);
  std::size_t room_ = first_room;
  std::size_t size_ = 0;  ///< bytes received
  std::size_t last_ = 0;  ///< of them those of the frame that was given out last
  bool ended_ = false;
};

}  // namespace tandem::tcp
