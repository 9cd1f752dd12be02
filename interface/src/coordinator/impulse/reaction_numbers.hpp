// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "tandem/signal.hpp"

namespace tandem {

/// A Reaction with its numbers: of n states, by p outputs.
class ReactionNumbers {
 public:
  ReactionNumbers(std::size_t n, std::vector<std::int32_t> outputs)
      : n_(n), outputs_(std::move(outputs)), a_(n * n), b0_(n * p()), b1_(n * p()), c_(4 * n), begin_(n) {}

  double& a(std::size_t i, std::size_t k) { return a_[i * n_ + k]; }
  double& b0(std::size_t i, std::size_t k) { return b0_[i * p() + k]; }
  double& b1(std::size_t i, std::size_t k) { return b1_[i * p() + k]; }
  double& c(std::size_t i, std::size_t power) { return c_[4 * i + power]; }
  double* begin() { return begin_.data(); }
  void clear() {
    for (auto* all : {&a_, &b0_, &b1_, &c_}) std::fill(all->begin(), all->end(), 0.0);
  }
  void set_origin(double t) { origin_ = t; }
  /// In place of output k as it is, what `gain` and `offset` make of it.
  void scale(std::size_t k, double gain, double offset) {
    for (std::size_t i = 0; i < n_; ++i) {
      c(i, 0) += b0(i, k) * offset, c(i, 1) += b1(i, k) * offset;
      b0(i, k) *= gain, b1(i, k) *= gain;
    }
  }
  std::size_t states() const { return n_; }
  /// Valid as long as these numbers are.
  Reaction view() const {
    return {static_cast<std::int32_t>(n_),
            static_cast<std::int32_t>(p()),
            outputs_.data(),
            origin_,
            a_.data(),
            b0_.data(),
            b1_.data(),
            c_.data(),
            begin_.data()};
  }

 private:
  std::size_t p() const { return outputs_.size(); }

  std::size_t n_;
  std::vector<std::int32_t> outputs_;
  std::vector<double> a_, b0_, b1_, c_, begin_;
  double origin_ = 0.0;
};

}  // namespace tandem
