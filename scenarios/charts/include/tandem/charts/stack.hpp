// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// Panels one below the other with the same time axis, which has its numbers at the lowest.
class Stack {
 public:
  /// `ylabel` stands beside each panel. The picture must outlive the stack.
  Stack(Picture& picture, std::size_t panels, std::string ylabel);

  /// Goes to the next panel below; `title` stands above it.
  void next(const std::string& title);
  /// Later plots go to the present panel, between these fractions of the width.
  void go_to(double left, double right);

 private:
  Picture& picture_;
  std::size_t panels_, row_ = 0;
  std::string ylabel_;
};

}  // namespace tandem::charts
