// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The surrogate where the fast side integrates it along with its own states.
#include "surrogate.hpp"

namespace tandem {

void Surrogate::prepare(double t, std::span<const Signal> u) {
  if (steps_ == 0) hear_of_start(u);
  steps_ = of_.degree + 1;  // it misses nothing at the start
  if (passed_) take_node(t, u);
}

/// Of each link P' = F, Q' = P, U' = Q, y' = v, R' = y, and
/// v' = (A_n + A'_n s) (F - K (y - y_begin) - C v) + g + g' s + e''(s). With K and C the rate A' is 0.
void Surrogate::describe(std::span<const ReactiveLink> links, ReactionTerms& to) const {
  using enum SurrogateLink::State;
  const auto row = [](std::size_t link, SurrogateLink::State state) {
    return link * SurrogateLink::states + state;
  };
  to.clear(slow_.begin());
  for (std::size_t i = 0; i < size(); ++i) {
    const ReactiveLink::End& f = links[i].effort;
    to.add_output(row(i, force_first), f.port, f.gain, 0.0);
    to.add(row(i, force_second), row(i, force_first), 1.0),
        to.add(row(i, force_third), row(i, force_second), 1.0);
    to.add(row(i, at), row(i, rate_of), 1.0), to.add(row(i, position_sum), row(i, at), 1.0);
    if (f.offset != 0.0) to.add_course(row(i, force_first), {f.offset});
    describe_acceleration(i, links, to);
    links_[i].get_states(to.begin() + i * SurrogateLink::states);
  }
}

void Surrogate::describe_acceleration(std::size_t i, std::span<const ReactiveLink> links,
                                      ReactionTerms& to) const {
  using enum SurrogateLink::State;
  const std::size_t v = i * SurrogateLink::states + rate_of;
  auto course = links_[i].pulse();
  course[0] += links_[i].smooth(), course[1] += links_[i].smooth_rate();
  for (std::size_t k = 0; k < size(); ++k) {
    const std::size_t e = i * size() + k;
    const ReactiveLink::End& f = links[k].effort;
    const double a = accelerance_.values()[e], rate = accelerance_.rates()[e];
    to.add_output(v, f.port, a * f.gain, rate * f.gain);
    course[0] += a * f.offset, course[1] += rate * f.offset;
    for (std::size_t j = 0; j < size() && !of_.stiffness.empty(); ++j) {
      const double spring = a * of_.stiffness[k * size() + j];
      to.add(v, j * SurrogateLink::states + at, -spring), course[0] += spring * begin_position_[j];
      to.add(v, j * SurrogateLink::states + rate_of, -a * of_.damping[k * size() + j]);
    }
  }
  to.add_course(v, course);
}

void Surrogate::jump_to(double t, std::span<const double> forces) {
  std::copy(forces.begin(), forces.end(), forces_[2].begin());
  if (of_.tells_velocities) find_accelerations(t);
}

void Surrogate::follow(const OwnStep& s, std::span<const double> forces, const double* z,
                       std::span<const Signal> u) {
  forces_[0] = forces_[2];
  std::copy(forces.begin(), forces.end(), forces_[2].begin());
  for (SurrogateLink& link : links_) link.go_to(z), z += SurrogateLink::states;
  end_step(s, u);
}

}  // namespace tandem
