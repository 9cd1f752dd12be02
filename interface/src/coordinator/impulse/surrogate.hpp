// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reaction_terms.hpp"
#include "rest_check.hpp"
#include "slow_step.hpp"
#include "surrogate_link.hpp"
#include "tandem/coordinator/impulse/accelerance.hpp"
#include "tandem/coordinator/impulse/reaction_check.hpp"
#include "tandem/coordinator/impulse/reactive_side.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem {

/// The model of impulse_surrogate(): its ports and its start, its own steps (surrogate_step.cpp), what is done where the slow
/// side passes a node and is heard of it (surrogate_node.cpp), and its states as bytes and as numbers (surrogate_states.cpp).
///
/// Where the fast side integrates it along (ReactiveSide) it takes no own steps: it says by what (describe) and follows
/// (surrogate_reaction.cpp).
class Surrogate {
 public:
  explicit Surrogate(ImpulseCoupling coupling);

  SubsystemInfo info() const;
  double own_step() const { return of_.own_step; }
  void end_at(double t_stop) { slow_.end_at(t_stop); }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;

  const ImpulseCoupling& coupling() const { return of_; }
  std::size_t size() const { return of_.links.size(); }  ///< links
  double node() const { return slow_.end(); }            ///< the next one of the slow side [s]
  /// Before a call of the fast side, at t: it hears of the slow side if that has passed a node.
  void prepare(double t, std::span<const Signal> u);
  /// By what it goes.
  void describe(std::span<const ReactiveLink> links, ReactionTerms& to) const;
  /// After a step of the fast side: the forces at its end, and the states of the reaction.
  void follow(const OwnStep& s, std::span<const double> forces, const double* z, std::span<const Signal> u);
  /// The forces jump at t, where it stands.
  void jump_to(double t, std::span<const double> forces);

  std::vector<std::string> remarks(double t_stop) const;
  /// At a node that it has reached and not heard of, or at the start.
  std::optional<std::vector<StateName>> states() const;
  void get_states(std::span<double> x) const;
  void set_states(std::span<const double> x);
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  using Forces = std::vector<double>;  ///< by link

  /// What the slow side does at the start, with all its inputs as they are then, but for these forces: before the first step.
  void hear_of_start(std::span<const Signal> u);
  void begin_links(const Forces& velocities, const Forces& free);
  bool varies() const { return !of_.accelerance_rate.empty(); }
  void read_accelerance(double node, std::span<const Signal> u);
  void check_rate(std::size_t e, double node);
  void turn_to_next(double s);
  void accelerate(std::size_t stage, double h, const double (&times)[3]);
  void take_spring(const Forces& forces, const Forces& y, const Forces& v, Forces& net) const;
  void find_accelerations(double t);
  void make_up_start(double t, std::span<const Signal> u);
  void take_node(double t, std::span<const Signal> u);
  void describe_acceleration(std::size_t i, std::span<const ReactiveLink> links, ReactionTerms& to) const;
  void end_step(const OwnStep& s, std::span<const Signal> u);
  void pass_node(const OwnStep& s);
  std::vector<double*> numbers();
  void check_reaction(std::span<const Signal> u, double node);

  ImpulseCoupling of_;
  SlowStep slow_;
  bool passed_ = false;             ///< the end of the slow side's step, and that has not been heard since
  int steps_ = 0;                   ///< own ones so far, up to degree + 1
  Accelerance accelerance_, next_;  ///< from the last node on; at the one that is taken
  std::vector<SurrogateLink> links_;
  std::vector<ReactionCheck> checks_;  ///< by link
  RestCheck rest_;
  double worst_ = 0.0, worst_at_ = 0.0;  ///< error of a check so far, and when [s]
  std::array<Forces, 3> forces_;         ///< at begin, middle and end of a step
  std::array<Forces, 4> stages_;         ///< accelerations at the stages of a step; else scratch
  Forces net_;  ///< of a stage; once a node is passed, the means over the slow side's step
  Forces positions_, velocities_;
  Forces accelerations_;   ///< at the end of the last own step, if velocities are told
  Forces begin_position_;  ///< where its springs have no force: that of the start goes with the rest
  double changed_ = 0.0,
         changed_at_ = 0.0;  ///< part of A by which it changed otherwise than by its rate, and when [s]
};

}  // namespace tandem
