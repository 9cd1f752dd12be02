// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The exact solution of linear systems that are coupled with sampled ones: between two changes of a held
// value all is one linear system with constant inputs, solved by the exponential of its matrix.
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "linear_controller.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::test {

struct Part {
  Linear system;
  std::optional<LinearController::Times> sampled = {};  ///< none: it is continuous
};

/// From output to input; between sampled parts with `memory` the value just before; lag [s] of held values.
struct Wire {
  int from, output, to, input;
  bool memory = false;
  double lag = 0.0;
};

class ExactSamples {
  template <class T>
  static auto& at(T& list, int k) {
    return list[static_cast<std::size_t>(k)];
  }

 public:
  struct Sample {
    double t;  ///< from when on it holds
    VectorXd y;
  };

  ExactSamples(std::vector<Part> parts, std::vector<Wire> wires, double t_start)
      : parts_(std::move(parts)), wires_(std::move(wires)), t_start_(t_start), tolerance_(t_start) {
    for (const Part& part : parts_) {
      x_.push_back(part.system.x);
      taken_.push_back(0);
      samples.push_back({});
      if (part.sampled) samples.back().push_back({t_start, part.system.c * part.system.x});
    }
    t_ = t_start;
  }

  /// Outputs of a continuous part just before t; t may not fall.
  VectorXd before(int part, double t) {
    while (true) {
      const double next = next_event();
      if (!tolerance_.before(next, t)) break;
      go_to(next);
      act();
    }
    go_to(std::max(t, t_));
    return at(parts_, part).system.c * at(x_, part);
  }
  /// All samples up to t, that instant included.
  void act_up_to(double t) {
    for (double next = next_event(); !tolerance_.before(t, next); next = next_event()) {
      go_to(next);
      act();
    }
  }

  std::vector<std::vector<Sample>> samples;  ///< by part

 private:
  int size() const { return static_cast<int>(parts_.size()); }
  double instant(int part) const {
    const auto& s = *at(parts_, part).sampled;
    return t_start_ + s.offset + at(taken_, part) * s.period;
  }

  /// The next instant, or change of a held value.
  double next_event() const {
    double next = std::numeric_limits<double>::max();
    for (int i = 0; i < size(); ++i)
      if (at(parts_, i).sampled) next = std::min(next, instant(i));
    for (const Wire& w : wires_)
      for (const Sample& s : at(samples, w.from))
        if (tolerance_.before(t_, s.t + w.lag)) next = std::min(next, s.t + w.lag);
    return next;
  }

  /// The held value at t, with what is new there or just before.
  double held(const Wire& w, double t, bool just_before) const {
    const auto& list = at(samples, w.from);
    std::size_t k = 0;
    while (k + 1 < list.size() && (just_before ? tolerance_.before(list[k + 1].t + w.lag, t)
                                               : !tolerance_.before(t, list[k + 1].t + w.lag)))
      ++k;
    return list[k].y[w.output];
  }

  VectorXd inputs(int part, double t) const {
    VectorXd u = VectorXd::Zero(at(parts_, part).system.b.cols());
    for (const Wire& w : wires_)
      if (w.to == part)
        u[w.input] += at(parts_, w.from).sampled ? held(w, t, w.memory)
                                                 : (at(parts_, w.from).system.c * at(x_, w.from))[w.output];
    return u;
  }

  void act() {
    std::vector<int> due;
    for (int i = 0; i < size(); ++i)
      if (at(parts_, i).sampled && !tolerance_.before(t_, instant(i))) due.push_back(i);
    for (const int i : due) at(samples, i).push_back({t_ + at(parts_, i).sampled->latency, {}});
    for (const int i : due) at(samples, i).back().y = at(parts_, i).system.c * at(x_, i);
    for (std::size_t pass = 0; pass <= due.size(); ++pass)
      for (const int i : due) {
        const Linear& s = at(parts_, i).system;
        at(samples, i).back().y = s.c * at(x_, i) + s.d * inputs(i, t_);
      }
    std::vector<VectorXd> u;
    for (const int i : due) u.push_back(inputs(i, t_));
    for (std::size_t k = 0; k < due.size(); ++k) {
      const Linear& s = at(parts_, due[k]).system;
      at(x_, due[k]) = (s.a * at(x_, due[k]) + s.b * u[k]).eval();
      ++at(taken_, due[k]);
    }
  }

  /// All continuous parts over a time in which no held value changes.
  void go_to(double t) {
    if (t <= t_) return;
    std::vector<Eigen::Index> first;
    Eigen::Index n = 0;
    for (const Part& part : parts_) {
      first.push_back(n);
      if (!part.sampled) n += part.system.x.size();
    }
    MatrixXd all = MatrixXd::Zero(n + 1, n + 1);
    VectorXd z = VectorXd::Zero(n + 1);
    z[n] = 1.0;
    for (int i = 0; i < size(); ++i)
      if (const Linear& s = at(parts_, i).system; !at(parts_, i).sampled) {
        all.block(at(first, i), at(first, i), s.a.rows(), s.a.cols()) += s.a;
        z.segment(at(first, i), s.x.size()) = at(x_, i);
      }
    for (const Wire& w : wires_) {
      const Linear &to = at(parts_, w.to).system, &from = at(parts_, w.from).system;
      if (at(parts_, w.to).sampled) continue;
      const VectorXd column = to.b.col(w.input);
      if (at(parts_, w.from).sampled)
        all.block(at(first, w.to), n, column.size(), 1) += column * held(w, (t_ + t) / 2.0, false);
      else
        all.block(at(first, w.to), at(first, w.from), column.size(), from.x.size()) +=
            column * from.c.row(w.output);
    }
    z = (((t - t_) * all).exp() * z).eval();
    for (int i = 0; i < size(); ++i)
      if (!at(parts_, i).sampled) at(x_, i) = z.segment(at(first, i), at(x_, i).size());
    t_ = t;
  }

  std::vector<Part> parts_;
  std::vector<Wire> wires_;
  double t_start_, t_ = 0.0;
  TimeTolerance tolerance_;
  std::vector<VectorXd> x_;
  std::vector<int> taken_;
};

}  // namespace tandem::test
