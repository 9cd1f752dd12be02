// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The surrogate where the fast side integrates it along with its own states.
#include "surrogate.hpp"

namespace tandem {

void Surrogate::prepare(double t, std::span<const Signal> u) {
  steps_ = of_.degree + 1;  // it misses nothing at the start
  if (passed_) take_node(t, u);
}

/// Of each link P' = F, Q' = P, U' = Q, y' = v, R' = y, and
/// v' = (A_n + A'_n s) (F - K (y - y_begin) - C v) + g + g' s + e''(s). With K and C the rate A' is 0.
void Surrogate::describe(ReactionNumbers& to) const {
  using enum SurrogateLink::State;
  const auto row = [](std::size_t link, SurrogateLink::State state) {
    return link * SurrogateLink::states + state;
  };
  to.clear(), to.set_origin(slow_.begin());
  for (std::size_t i = 0; i < size(); ++i) {
    to.b0(row(i, force_first), i) = 1.0;
    to.a(row(i, force_second), row(i, force_first)) = to.a(row(i, force_third), row(i, force_second)) = 1.0;
    to.a(row(i, at), row(i, rate_of)) = to.a(row(i, position_sum), row(i, at)) = 1.0;
    const std::size_t v = row(i, rate_of);
    const auto pulse = links_[i].pulse();
    for (std::size_t power = 0; power < pulse.size(); ++power) to.c(v, power) = pulse[power];
    to.c(v, 0) += links_[i].smooth(), to.c(v, 1) += links_[i].smooth_rate();
    for (std::size_t k = 0; k < size(); ++k) {
      const std::size_t e = i * size() + k;
      to.b0(v, k) = accelerance_.values()[e], to.b1(v, k) = accelerance_.rates()[e];
      for (std::size_t j = 0; j < size() && !of_.stiffness.empty(); ++j) {
        const double spring = accelerance_.values()[e] * of_.stiffness[k * size() + j];
        to.a(v, row(j, at)) -= spring, to.c(v, 0) += spring * begin_position_[j];
        to.a(v, row(j, rate_of)) -= accelerance_.values()[e] * of_.damping[k * size() + j];
      }
    }
    links_[i].get_states(to.begin() + i * SurrogateLink::states);
  }
}

void Surrogate::jump_to(std::span<const double> forces) {
  std::copy(forces.begin(), forces.end(), forces_[2].begin());
}

void Surrogate::follow(const OwnStep& s, std::span<const double> forces, const double* z,
                       std::span<const Signal> u) {
  forces_[0] = forces_[2];
  jump_to(forces);
  for (SurrogateLink& link : links_) link.go_to(z), z += SurrogateLink::states;
  end_step(s, u);
}

}  // namespace tandem
