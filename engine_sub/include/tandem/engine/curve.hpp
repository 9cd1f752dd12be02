// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem::engine {

/// A function of one variable through given points: straight lines between them, or the monotone cubic of
/// F. Fritsch, R. Carlson, SIAM J. Numer. Anal. 17 (1980) 238 with slopes by Brodlie's weighted harmonic mean
/// (F. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300): no overshoot, once differentiable.
class Curve {
 public:
  enum class Between { linear, cubic };
  /// Outside the points: the last value, or the last slope. `refuse` is the last slope too, for a step that
  /// tries times or states that it does not keep; whoever keeps one refuses it.
  enum class Beyond { hold, extend, refuse };

  /// x: ascending, two or more, as many as y. Throws Error that names `owner` and what is wrong.
  Curve(const std::string& owner, std::vector<double> x, std::vector<double> y, Between between,
        Beyond beyond);

  double operator()(double x) const;
  const std::vector<double>& x() const { return x_; }
  Beyond beyond() const { return beyond_; }

 private:
  double outside(std::size_t end, double x) const;
  std::vector<double> x_, y_, slope_;
  Between between_;
  Beyond beyond_;
};

}  // namespace tandem::engine
