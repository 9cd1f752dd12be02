// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Linear subsystems that integrate themselves.
#pragma once
#include <Eigen/Dense>
#include <map>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "exact_pieces.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// x' = a x + b u, y = c x of a continuous side; x_{k+1} = a x_k + b u_k, y_k = c x_k + d u_k of a sampled
/// one.
struct Linear {
  MatrixXd a, b, c, d;
  VectorXd x;  ///< at the start
};

inline std::vector<Port> ports(const std::string& name, Eigen::Index count, bool input) {
  Port port{name, "1", static_cast<int>(count)};
  if (input) port.start = 0.0;
  return {port};
}

/// How a continuous side integrates.
enum class Method {
  exact,      ///< under polynomial inputs, from break to break
  rk4,        ///< over breaks
  rk4_split,  ///< from break to break
};

/// For FixedStep.
class LinearModel {
 public:
  LinearModel(Linear system, double h, Method method) : s_(std::move(system)), h_(h), method_(method) {}

  SubsystemInfo info() const {
    return {"linear",
            ports("u", s_.b.cols(), true),
            ports("y", s_.c.rows(), false),
            {},
            {.serializes_state = true}};
  }
  double own_step() const { return h_; }
  void start(double, std::span<const double>) { x_ = s_.x; }
  void outputs(double* y) const { Eigen::Map<VectorXd>(y, s_.c.rows()) = s_.c * x_; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    if (method_ == Method::rk4) return runge_kutta(s.begin, s.end, u);
    std::vector<double> breaks{s.begin, s.end};
    for (const Signal& signal : u)
      for (const Segment& piece : signal.segments())
        if (piece.end > s.begin && piece.end < s.end) breaks.push_back(piece.end);
    std::sort(breaks.begin(), breaks.end());
    for (std::size_t k = 1; k < breaks.size(); ++k)
      if (breaks[k] > breaks[k - 1]) piece(breaks[k - 1], breaks[k], u);
  }
  void write(ByteWriter& to) const { to.put_doubles({x_.data(), static_cast<std::size_t>(x_.size())}); }
  void read(ByteReader& from) {
    x_.resize(s_.x.size());
    from.take_doubles({x_.data(), static_cast<std::size_t>(x_.size())});
  }

 private:
  static constexpr int powers = TANDEM_MAX_COEFFICIENTS;

  void piece(double from, double to, std::span<const Signal> u) {
    method_ == Method::exact ? propagate(from, to, u) : runge_kutta(from, to, u);
  }

  /// (x, u, u', u'' ...) is a linear system of its own.
  void propagate(double from, double to, std::span<const Signal> u) {
    const auto n = s_.x.size(), m = s_.b.cols();
    VectorXd z = VectorXd::Zero(n + powers * m);
    z.head(n) = x_;
    for (Eigen::Index i = 0; i < m; ++i) {
      const tandem_signal c{u[i].segments().data(), static_cast<std::int32_t>(u[i].segments().size()),
                            u[i].degree(), nullptr};
      const auto p = shifted(*tandem_signal_at(&c, (from + to) / 2.0), from);
      double factorial = 1.0;
      for (int k = 0; k < powers; factorial *= ++k)
        z[n + k * m + i] = p[static_cast<std::size_t>(k)] * factorial;
    }
    x_ = (over(to - from) * z).head(n);
  }
  const MatrixXd& over(double h) {
    MatrixXd& map = maps_[h];
    if (map.size() > 0) return map;
    const auto n = s_.x.size(), m = s_.b.cols();
    MatrixXd all = MatrixXd::Zero(n + powers * m, n + powers * m);
    all.topLeftCorner(n, n) = s_.a;
    all.block(0, n, n, m) = s_.b;
    all.block(n, n + m, (powers - 1) * m, (powers - 1) * m).setIdentity();
    return map = (h * all).exp();
  }

  VectorXd slope(const VectorXd& x, double t, double inside, std::span<const Signal> u) const {
    VectorXd v(s_.b.cols());
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = value(u[i], t, inside);
    return s_.a * x + s_.b * v;
  }
  /// Where a step begins at a break it is the piece behind it that counts.
  double value(const Signal& u, double t, double inside) const {
    if (method_ == Method::rk4) return u.value(t);
    const tandem_signal c{u.segments().data(), static_cast<std::int32_t>(u.segments().size()), u.degree(),
                          nullptr};
    const tandem_signal one{tandem_signal_at(&c, inside), 1, u.degree(), nullptr};
    return tandem_signal_value(&one, t);
  }
  void runge_kutta(double from, double to, std::span<const Signal> u) {
    const double h = to - from, middle = from + h / 2.0;
    const VectorXd k1 = slope(x_, from, middle, u), k2 = slope(x_ + h / 2.0 * k1, middle, middle, u),
                   k3 = slope(x_ + h / 2.0 * k2, middle, middle, u), k4 = slope(x_ + h * k3, to, middle, u);
    x_ += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }

  Linear s_;
  double h_;
  Method method_;
  VectorXd x_;
  std::map<double, MatrixXd> maps_;
};

}  // namespace tandem::test
