// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/reduced.hpp"
#include "tandem/slow_model.hpp"

namespace tandem::mbs {

/// The equations of a mechanism for an impulse coupling, by the coordinates that take_reactions() has given ports.
class SlowMechanism final : public SlowModel, private InputSource {
 public:
  struct Link {
    int input;     ///< of the description
    int variable;  ///< of the displacement, which is it times the gain
    double gain;
  };
  /// live: the mechanism that moves; its inputs are those of here, but for forces on links and coordinates.
  SlowMechanism(std::shared_ptr<const Mechanism> live, std::vector<Link> links, std::vector<int> variables);

  int links() const override { return static_cast<int>(links_.size()); }
  std::vector<std::string> coordinates() const override { return named("coordinate."); }
  std::vector<std::string> reactions() const override { return named("reaction."); }
  std::vector<double> units() const override;
  void stand_at(double t) override { own_.at_time(t); }
  void accelerations(std::span<const double> q, std::span<const double> u, std::span<double> a) override;
  void answer(std::span<const double> q, std::span<const double> b, std::span<double> a) override;
  void inertia(std::span<const double> q, std::span<const double> a, std::span<double> b) override;
  void pushes(std::span<const double> q, std::span<double> b) override;
  void motions(std::span<const double> q, std::span<const double> u, std::span<double> y,
               std::span<double> rates) override;
  void write(ByteWriter& to) const override;
  void read(ByteReader& from) override;

 private:
  void at(double t, std::span<InputValue> values) override;
  std::vector<std::string> named(const char* prefix) const;

  std::shared_ptr<const Mechanism> live_;
  std::vector<Link> links_;  ///< the first coordinates are those of the links
  Mechanism own_;
  Reduced reduced_;
  std::vector<bool> silent_;  ///< inputs that count as 0
};

/// Null where links are other than forces, and positions with the ports of take_reactions().
/// - ports: inputs of the description.
std::shared_ptr<SlowModel> slow_model_of(std::shared_ptr<const Mechanism> live, const std::vector<int>& ports,
                                         std::span<const SlowLink> links);

}  // namespace tandem::mbs
