// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace tandem::study {

/// Processes that share a sweep, by their numbers: 0 hands out its work, the others do it. All have the same
/// study, scenario and program. One thread of a process uses them.
class Ranks {
 public:
  struct Message {
    int from;
    std::vector<std::uint8_t> bytes;
  };

  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// It does not wait for the other side. Messages between two ranks keep their order.
  virtual void send(int to, const std::vector<std::uint8_t>& bytes) = 0;
  /// The next message that has come, if there is one. It does not wait.
  virtual std::optional<Message> receive() = 0;
};

}  // namespace tandem::study
