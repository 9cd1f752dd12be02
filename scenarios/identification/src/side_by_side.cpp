// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tandem::identification {
namespace {

class SideBySide {
 public:
  SideBySide(Subsystem& real, Subsystem& model, std::span<const double> u0)
      : real_(real), model_(model), u0_(u0), stride_(real.info().row_size()) {
    for (const double u : u0) segments_.push_back({0.0, 0.0, {u}});
    for (const Segment& one : segments_) signals_.emplace_back(&one, 1, 0);
    values_.resize(static_cast<std::size_t>(stride_ - Samples::header));
  }

  std::optional<double> apart(const TimeSpan& span, double part) {
    std::vector<double> a(static_cast<std::size_t>(stride_ * rows)), b = a;
    Samples y(a.data(), stride_, rows), of_model(b.data(), stride_, rows);
    real_.initialize(span.start, span.stop, u0_, y), model_.initialize(span.start, span.stop, u0_, of_model);
    while (y.size() > 0) {
      const std::int64_t both = std::min(y.size(), of_model.size());
      for (std::int64_t row = 0; row < both; ++row)
        compare(a.data() + row * stride_, b.data() + row * stride_);
      if (std::max(y.size(), of_model.size()) > both + 1) return span.stop;
      if (y.size() != of_model.size()) break;  // by rounding, the last step fits into the span of one
      y = Samples(a.data(), stride_, rows), of_model = Samples(b.data(), stride_, rows);
      real_.advance(span.stop, false, signals_, y), model_.advance(span.stop, false, signals_, of_model);
    }
    const auto far = [part](const Value& v) { return !(v.off <= part * v.peak); };
    const auto it = std::find_if(values_.begin(), values_.end(), far);
    return it == values_.end() ? std::nullopt : std::optional(it->at);
  }

 private:
  static constexpr std::int64_t rows = 256;
  struct Value {
    double peak = 1e-9, off = 0.0, at = 0.0;
  };
  void compare(const double* a, const double* b) {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      Value& value = values_[k];
      const double own = a[Samples::header + k], off = std::abs(own - b[Samples::header + k]);
      value.peak = std::max(value.peak, std::abs(own));
      if (!(off <= value.off)) value.off = off, value.at = a[0];
    }
  }

  Subsystem &real_, &model_;
  std::span<const double> u0_;
  std::int64_t stride_;
  std::vector<Value> values_;
  std::vector<Segment> segments_;
  std::vector<Signal> signals_;
};

}  // namespace

std::optional<double> apart(Subsystem& real, Subsystem& model, const TimeSpan& span,
                            std::span<const double> u0, double part) {
  return SideBySide(real, model, u0).apart(span, part);
}

}  // namespace tandem::identification
