// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "force_set.hpp"
#include "tandem/mbs/mechanism/force_element.hpp"
#include "tandem/mbs/mechanism/numbering.hpp"

namespace tandem::mbs {

/// As ElementState::size, of a mechanism with that unit().
std::vector<double> sizes_of(const Description& description, const ForceElement& element, double unit);

/// What an element reads, gathered from all coordinates.
class GatheredElement {
 public:
  GatheredElement(const ForceElement& element, const Numbering& numbering, std::vector<double> sizes = {})
      : element_(&element), sizes_(std::move(sizes)) {
    for (const Coordinate& c : element.coordinates()) to_.push_back(numbering.of(c));
    x_.resize(to_.size());
    v_.resize(to_.size());
    u_.resize(element.inputs().size());
  }
  ElementState gather(const double* q, const double* v, std::span<const InputValue> inputs) {
    for (std::size_t i = 0; i < to_.size(); ++i) x_[i] = q[to_[i]], v_[i] = v[to_[i]];
    for (std::size_t i = 0; i < u_.size(); ++i)
      u_[i] = inputs[static_cast<std::size_t>(element_->inputs()[i])].value;
    return {x_.data(), v_.data(), u_.data(), sizes_.empty() ? nullptr : sizes_.data()};
  }
  /// With the inputs of the last gather(), where positions are further by so many seconds of the rates v, and
  /// rates by so many of the accelerations a.
  ElementState ahead(const State& s, double by_rates, double by_accelerations) {
    for (std::size_t i = 0; i < to_.size(); ++i)
      x_[i] = s.q[to_[i]] + by_rates * s.v[to_[i]], v_[i] = s.v[to_[i]] + by_accelerations * s.a[to_[i]];
    return {x_.data(), v_.data(), u_.data(), sizes_.empty() ? nullptr : sizes_.data()};
  }
  /// The time [s] in which the fastest of the coordinates goes by its size; 1 s if none moves.
  double time_of_sizes(const State& s) const {
    double most = 0.0;
    for (std::size_t i = 0; i < to_.size(); ++i) most = std::max(most, std::abs(s.v[to_[i]]) / size(i));
    return most > 0.0 ? 1.0 / most : 1.0;
  }
  /// The time [s] in which a rate first changes by as much as it is, or, where it is less, by what it has
  /// after its size from rest; 1 s if none changes.
  double time_of_rates(const State& s) const {
    double most = 0.0;
    for (std::size_t i = 0; i < to_.size(); ++i) {
      const double a = std::abs(s.a[to_[i]]);
      if (a > 0.0) most = std::max(most, a / std::max(std::abs(s.v[to_[i]]), std::sqrt(a * size(i))));
    }
    return most > 0.0 ? 1.0 / most : 1.0;
  }
  const ForceElement& element() const { return *element_; }
  const std::vector<int>& coordinates() const { return to_; }

 private:
  double size(std::size_t i) const { return sizes_.empty() ? 1.0 : sizes_[i]; }

  const ForceElement* element_;
  std::vector<int> to_;
  std::vector<double> sizes_;  ///< as ElementState::size
  std::vector<double> x_, v_, u_;
};

class ElementSet final : public ForceSet {
 public:
  explicit ElementSet(const std::vector<InputValue>& inputs) : inputs_(inputs) {}
  void add(const ForceElement& element, const Numbering& numbering, std::vector<double> sizes) {
    all_.emplace_back(element, numbering, std::move(sizes));
    const auto size = static_cast<int>(all_.back().coordinates().size());
    if (size > force_.size()) force_.resize(size);
    k_.emplace_back(size, size);
    c_.emplace_back(size, size);
  }
  bool empty() const { return all_.empty(); }

  void add(const double* q, const double* v, double* force) const override {
    for (GatheredElement& one : all_) {
      const auto& to = one.coordinates();
      std::fill_n(force_.data(), to.size(), 0.0);
      one.element().add(one.gather(q, v, inputs_), force_.data());
      for (std::size_t i = 0; i < to.size(); ++i) force[to[i]] += force_[static_cast<int>(i)];
    }
  }

  std::vector<std::pair<int, int>> entries() const override {
    std::vector<std::pair<int, int>> list;
    for (const GatheredElement& one : all_)
      for (const int column : one.coordinates())
        for (const int row : one.coordinates()) list.emplace_back(row, column);
    return list;
  }

  void add_derivatives(const double* q, const double* v, double* k, double* c) const override {
    const int* to = to_.data();
    for (std::size_t e = 0; e < all_.size(); ++e) {
      k_[e].setZero();
      c_[e].setZero();
      all_[e].element().add_derivatives(all_[e].gather(q, v, inputs_), k_[e], c_[e]);
      for (int entry = 0; entry < k_[e].size(); ++entry, ++to)
        k[*to] += k_[e].data()[entry], c[*to] += c_[e].data()[entry];
    }
  }

  double potential(const double* q) const override {
    double sum = 0.0;
    for (GatheredElement& one : all_) sum += one.element().potential(one.gather(q, q, inputs_).x);
    return sum;
  }

 private:
  const std::vector<InputValue>& inputs_;
  mutable std::vector<GatheredElement> all_;
  mutable Eigen::VectorXd force_;
  mutable std::vector<Eigen::MatrixXd> k_, c_;
};

}  // namespace tandem::mbs
