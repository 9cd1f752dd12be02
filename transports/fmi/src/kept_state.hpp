// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "instance.hpp"

namespace tandem::fmi {

/// A state that an FMU gave, shared by those that keep it, and freed with the last of them.
class KeptState {
 public:
  KeptState() = default;
  /// Of the instance as it is.
  static KeptState of(const std::shared_ptr<Instance>& instance);
  static KeptState from(const std::shared_ptr<Instance>& instance, std::span<const std::byte> bytes);
  explicit operator bool() const { return state_ != nullptr; }
  void put_back(Instance& to) const;
  std::vector<std::byte> bytes(Instance& of) const;

 private:
  KeptState(const std::shared_ptr<Instance>& of, void* state);
  std::shared_ptr<void> state_;
  int made_ = 0;  ///< Instance::made() of who gave it
};

}  // namespace tandem::fmi
