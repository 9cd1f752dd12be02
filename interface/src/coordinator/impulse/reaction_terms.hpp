// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "tandem/signal.hpp"

namespace tandem {

/// A Reaction with what it points to, put together state by state.
class ReactionTerms {
 public:
  explicit ReactionTerms(std::size_t states) : begin_(states) {}

  std::size_t states() const { return begin_.size(); }
  double* begin() { return begin_.data(); }
  const double* begin() const { return begin_.data(); }
  /// From the beginning again, about t [s].
  void clear(double t) { origin_ = t, terms_.clear(), courses_.clear(); }
  void add(std::size_t to, std::size_t from, double factor) { put(to, from, factor, 0.0); }
  /// By a scalar output.
  void add_output(std::size_t to, int output, double factor, double rate) {
    put(to, states() + static_cast<std::size_t>(output), factor, rate);
  }
  void add_course(std::size_t to, const std::array<double, 4>& c) {
    courses_.push_back({static_cast<std::int32_t>(to), 0, {c[0], c[1], c[2], c[3]}});
  }
  /// Valid as long as these terms are, and stay.
  Reaction view() const {
    return {static_cast<std::int32_t>(states()),
            static_cast<std::int32_t>(terms_.size()),
            static_cast<std::int32_t>(courses_.size()),
            origin_,
            terms_.data(),
            courses_.data(),
            begin_.data()};
  }

 private:
  void put(std::size_t to, std::size_t from, double factor, double rate) {
    terms_.push_back({static_cast<std::int32_t>(to), static_cast<std::int32_t>(from), factor, rate});
  }

  std::vector<tandem_reaction_term> terms_;
  std::vector<tandem_reaction_course> courses_;
  std::vector<double> begin_;
  double origin_ = 0.0;
};

}  // namespace tandem
