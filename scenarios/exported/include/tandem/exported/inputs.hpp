// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/signal.hpp"

namespace tandem::exported {

/// The inputs of an FMU as functions of time. The value that was set at the begin of a step goes on by the
/// derivatives that were set with it. Without them it is held, or goes on along a line through the value at the
/// begin of the step before.
class Inputs {
 public:
  static constexpr int highest_order = TANDEM_MAX_COEFFICIENTS - 1;

  explicit Inputs(std::vector<double> start)
      : now_(std::move(start)), before_(now_), rates_(now_.size()), segments_(now_.size()) {}

  void set(int input, double value) { now_[static_cast<std::size_t>(input)] = value; }
  double value(int input) const { return now_[static_cast<std::size_t>(input)]; }
  const std::vector<double>& values() const { return now_; }
  /// For the next step. Throws Error for an order that is not 1 to highest_order.
  void set_derivative(int input, int order, double value);
  void extrapolate(bool whether) { extrapolates_ = whether; }
  bool extrapolates() const { return extrapolates_; }

  /// Over the step from `begin` to `end` [s]; valid until the next call.
  std::span<const Signal> over(double begin, double end);
  /// That step is done.
  void step_done(double begin);
  /// As they are at t [s], where the last step ended and to which they may have jumped, on the slopes that were set
  /// since then or else go on; valid until the next call.
  std::span<const Signal> jumped(double t);

  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  struct Rates {
    int order = 0;
    double of[highest_order] = {};  ///< first, second, ..
  };
  void line(std::size_t input, double begin, Segment& to) const;
  int give_rates(std::size_t input, Segment& to) const;

  std::vector<double> now_, before_;
  std::vector<Rates> rates_;
  std::vector<Segment> segments_;
  std::vector<Signal> signals_ = {};
  double begin_before_ = 0.0;  ///< of the step before [s]
  bool has_before_ = false, extrapolates_ = false;
};

}  // namespace tandem::exported
