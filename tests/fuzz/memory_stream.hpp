// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>

#include "stream.hpp"

namespace tandem::fuzz {

/// A peer that has sent these bytes and closed, and takes whatever it is sent.
class MemoryStream final : public tcp::Stream {
 public:
  MemoryStream(const std::uint8_t* data, std::size_t size) : left_(std::as_bytes(std::span(data, size))) {}

  std::optional<std::size_t> read(std::span<std::byte> to, wire::Deadline) override {
    const std::size_t count = std::min(to.size(), left_.size());
    std::copy_n(left_.begin(), count, to.begin());
    left_ = left_.subspan(count);
    return count;
  }
  void write(std::span<const std::byte>, wire::Deadline) override {}
  void shut_down() noexcept override {}

 private:
  std::span<const std::byte> left_;
};

inline std::unique_ptr<wire::Channel> channel_of(const std::uint8_t* data, std::size_t size) {
  return std::make_unique<tcp::StreamChannel>(std::make_unique<MemoryStream>(data, size), "memory");
}

}  // namespace tandem::fuzz
