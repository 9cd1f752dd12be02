// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "force_set.hpp"

namespace tandem::mbs {

/// Springs and dampers on relative coordinates.
class RelativeSpringSet final : public ForceSet {
 public:
  void add(int coordinate, const SpringLaw& law) { all_.push_back({coordinate, law}); }
  bool empty() const { return all_.empty(); }

  void add(const double* q, const double* v, double* force) const override {
    for (const auto& [i, law] : all_) force[i] -= law.at(q[i], v[i]).force;
  }
  std::vector<std::pair<int, int>> entries() const override {
    std::vector<std::pair<int, int>> list;
    for (const auto& [i, law] : all_) list.emplace_back(i, i);
    return list;
  }
  void add_derivatives(const double* q, const double* v, double* k, double* c) const override {
    const int* to = to_.data();
    for (const auto& [i, law] : all_) {
      const auto pull = law.at(q[i], v[i]);
      k[*to] += pull.by_x, c[*to] += pull.by_v;
      ++to;
    }
  }
  double potential(const double* q) const override {
    double sum = 0.0;
    for (const auto& [i, law] : all_) sum += law.potential(q[i]);
    return sum;
  }

 private:
  struct One {
    int coordinate;
    SpringLaw law;
  };
  std::vector<One> all_;
};

/// Inputs that act on single coordinates, times a gain.
class LoadSet final : public ForceSet {
 public:
  explicit LoadSet(const std::vector<InputValue>& inputs) : inputs_(inputs) {}
  void add(int coordinate, int input, double gain) {
    if (gain != 0.0) all_.push_back({coordinate, static_cast<std::size_t>(input), gain});
  }
  bool empty() const { return all_.empty(); }

  void add(const double*, const double*, double* force) const override {
    for (const One& one : all_) force[one.coordinate] += one.gain * inputs_[one.input].value;
  }

 private:
  struct One {
    int coordinate;
    std::size_t input;
    double gain;
  };
  const std::vector<InputValue>& inputs_;
  std::vector<One> all_;
};

}  // namespace tandem::mbs
