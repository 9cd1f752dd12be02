// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>

#include "linear_sides.hpp"
#include "tandem/sampled.hpp"

namespace tandem::test {

/// For Sampled.
class LinearController {
 public:
  struct Times {
    double period, offset = 0.0, latency = 0.0;
  };
  LinearController(Linear system, Times times) : s_(std::move(system)), times_(times) {}

  SubsystemInfo info() const {
    SubsystemInfo info{"controller",
                       ports("u", s_.b.cols(), true),
                       ports("y", s_.c.rows(), false),
                       {},
                       {.serializes_state = true}};
    for (int o = 0; o < s_.d.rows(); ++o)
      for (int i = 0; i < s_.d.cols(); ++i)
        if (s_.d(o, i) != 0.0) info.feedthrough.push_back({o, i});
    return info;
  }
  double own_step() const { return times_.period; }
  double offset() const { return times_.offset; }
  double latency() const { return times_.latency; }
  void start(double, std::span<const double>) { x_ = s_.x; }
  void outputs(double* y) const { Eigen::Map<VectorXd>(y, s_.c.rows()) = s_.c * x_; }
  void outputs(double* y, std::span<const double> u) const {
    Eigen::Map<VectorXd> to(y, s_.c.rows());
    to = s_.c * x_ + s_.d * Eigen::Map<const VectorXd>(u.data(), s_.b.cols());
  }
  void step(const OwnStep& s, std::span<const Signal> u) {
    VectorXd v(s_.b.cols());
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = u[i].value(s.begin);
    x_ = (s_.a * x_ + s_.b * v).eval();
  }
  void write(ByteWriter& to) const { to.put_doubles({x_.data(), static_cast<std::size_t>(x_.size())}); }
  void read(ByteReader& from) {
    x_.resize(s_.x.size());
    from.take_doubles({x_.data(), static_cast<std::size_t>(x_.size())});
  }

 private:
  Linear s_;
  Times times_;
  VectorXd x_;
};

}  // namespace tandem::test
