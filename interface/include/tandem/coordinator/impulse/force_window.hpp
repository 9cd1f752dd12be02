// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

namespace tandem {

class ByteReader;
class ByteWriter;

/// Integrals of a force over one step of the slow side, that of the force itself first: from zero at its begin.
struct ForceIntegrals {
  double first = 0.0, second = 0.0, third = 0.0;
};

/// The constant force that stands for a ripple of any frequency over a step of the slow side: a second difference of
/// its double integral, extrapolated to the middle of that step. At a node the second difference leaves a sample of
/// the ripple alone, so what the slow side makes of it stays bounded at every frequency, and sums never drift.
///
/// X is the double integral at the middle of the coming step, extrapolated from what is known at its begin. The force is
/// the second divided difference of X. What is kept is relative to the straight line that the double integral has at
/// the last node. No difference sees that line, and sums would lose their digits to it.
class ForceWindow {
 public:
  enum class Kind {
    hat,       ///< X from the double integral at the last two nodes
    b_spline,  ///< X from its means over the last three steps, which are free of the ripple itself
  };

  /// first_step [s]: that of the slow side. Before it the force was zero, for ever.
  ForceWindow(Kind kind, double first_step);

  /// The mean force over the step that ends at this node.
  /// - of: over that step.
  /// - length, next [s]: of that step, and of the coming one.
  double pass(const ForceIntegrals& of, double length, double next);

  /// What it keeps but for the lengths of steps.
  std::array<double*, 6> numbers();

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  struct Box {
    double mean, length;  ///< of the double integral, over so long [s]
  };
  double hat(const ForceIntegrals& of, double length, double next);
  double b_spline(const ForceIntegrals& of, double length, double next);

  Kind kind_;
  Box boxes_[3];  ///< the newest first
  double slope_ = 0.0, middle_ = 0.0,
         rate_ = 0.0;  ///< mean slope of the last step; X; its divided difference
};

}  // namespace tandem
