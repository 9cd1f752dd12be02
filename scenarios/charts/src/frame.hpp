// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// What a picture has around its panels.
struct Surroundings {
  std::string title;
  std::vector<std::vector<Curve>> legends;  ///< each a block of its own
  std::vector<std::string> caption;
};

/// A picture with a grid of panels.
class Frame {
 public:
  struct Grid {
    int rows, columns;
    int height = 300;  ///< of a panel, with its title and its numbers [pixels]
    int left = 85;     ///< room for the numbers of the first column [pixels]
    int numbers = 32;  ///< room for those below a panel [pixels]
    int foot = 45;     ///< room below the last row [pixels]
    int width = 0;     ///< of the picture [pixels]; 0: by the columns
  };
  Frame(const std::string& name, Grid grid, const Surroundings& around);

  Picture& picture() { return picture_; }
  /// Later plots go to this panel; `title` stands above it.
  void go_to(int row, int column, const std::string& title);
  /// One of `count` side by side, each with numbers of its own.
  void go_to_window(int row, std::size_t which, std::size_t count, const std::string& title);

 private:
  Grid grid_;
  int width_, top_, height_;  ///< top_: where the panels begin, from above [pixels]
  void go_to(int row, double left, double right, double gap, const std::string& title);
  Picture picture_;
};

/// Texts of at most `width` letters, broken between words.
std::vector<std::string> broken(const std::vector<std::string>& lines, std::size_t width);

}  // namespace tandem::charts
