// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <utility>

#include "tandem/transports/open.hpp"

namespace tandem::test {

/// A subsystem that keeps its states to itself.
class Hidden final : public Subsystem {
 public:
  explicit Hidden(std::unique_ptr<Subsystem> inner) : inner_(std::move(inner)), info_(inner_->info()) {
    info_.abilities = {.lands = info_.abilities.lands, .restarts = true};
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override {
    return inner_->initialize(t_start, t_stop, u0, y);
  }
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override {
    return inner_->advance(t_limit, land, u, y);
  }

 private:
  std::unique_ptr<Subsystem> inner_;
  SubsystemInfo info_;
};

/// The same sources, with those of these names hidden.
inline Builtins hiding(Builtins all, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    auto& source = all.models.at(name);
    source.make = [make = source.make](const Address& address, Parameters& parameters) {
      return std::make_unique<Hidden>(make(address, parameters));
    };
  }
  return all;
}

}  // namespace tandem::test
