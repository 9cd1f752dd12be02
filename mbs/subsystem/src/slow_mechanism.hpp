// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/reduced.hpp"
#include "tandem/slow_model.hpp"

namespace tandem::mbs {

/// Of the mechanism that moves: all its coordinates, and its inputs by those of the description, but for those that are
/// functions of time.
using WhereItIs = std::function<void(Eigen::VectorXd& q, std::vector<InputValue>& inputs)>;

/// The equations of a mechanism for an impulse coupling, by the coordinates that take_reactions() has given ports.
class SlowMechanism final : public SlowModel, private InputSource {
 public:
  struct Link {
    int input;     ///< of the description
    int variable;  ///< of the displacement, which is it times the gain
    double gain;
  };
  SlowMechanism(const Description& description, WhereItIs where, std::vector<Link> links,
                std::vector<int> variables);

  int links() const override { return static_cast<int>(links_.size()); }
  std::vector<std::string> coordinates() const override { return named("coordinate."); }
  std::vector<std::string> reactions() const override { return named("reaction."); }
  std::vector<double> units() const override;
  void stand_at(double t) override;
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

  WhereItIs where_;
  std::vector<Link> links_;  ///< the first coordinates are those of the links
  Mechanism own_;
  Reduced reduced_;
  std::vector<bool> silent_;  ///< inputs that count as 0
  double time_ = 0.0;
  std::vector<InputValue> inputs_;  ///< as they were then
};

/// Null where links are other than forces, and positions with the ports of take_reactions().
/// - ports: inputs of the description.
std::shared_ptr<SlowModel> slow_model_of(const Description& description, WhereItIs where,
                                         const std::vector<int>& ports, std::span<const SlowLink> links);

}  // namespace tandem::mbs
