// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/impulse/impulse_surrogate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "surrogate_link.hpp"
#include "tandem/coordinator/impulse/accelerance.hpp"
#include "tandem/coordinator/impulse/reaction_check.hpp"
#include "tandem/error.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem {
namespace {

/// So many fast periods a step of the slow side may be long for the window of the fewest steps.
constexpr double longest_hat = 0.65;
/// By so much of itself the slow side's answer to a force may differ from what A gives.
constexpr double largest_reaction_error = 1e-3;
/// By so much of itself A may change in a step otherwise than by the mean of its rates.
constexpr double largest_change = 0.01;

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(ErrorCode::invalid_argument, "impulse coupling: " + what);
}

class Surrogate {
 public:
  explicit Surrogate(ImpulseCoupling coupling) : of_(std::move(coupling)) {
    const auto above_zero = [](double one) { return std::isfinite(one) && one > 0.0; };
    require(above_zero(of_.own_step) && above_zero(of_.slow_step) && above_zero(of_.fast_period),
            "own steps and the fast period are to be above 0 s");
    require(of_.slow_step > of_.own_step, "the slow side's own step is not longer than the fast side's");
    require(of_.degree >= 1 && of_.degree <= 4, "the force is continued by a polynomial of degree 1 to 4");
    require(!of_.links.empty() && of_.accelerance.size() == of_.links.size() * of_.links.size(),
            "the accelerance is to be a matrix of all links");
    const std::size_t matrix = of_.links.size() * of_.links.size();
    require(of_.stiffness.empty() ? of_.damping.empty()
                                  : of_.stiffness.size() == matrix && of_.damping.size() == matrix,
            "stiffness and damping are to be matrices of all links");
    require(of_.accelerance_rate.empty() ||
                (of_.accelerance_rate.size() == matrix && of_.accelerance_units.size() == matrix),
            "the rate of the accelerance and its units are to be matrices of all links");
    next_ = Accelerance(of_.accelerance, std::vector<double>(matrix));
    for (Forces* one : {&forces_[0], &forces_[1], &forces_[2], &stages_[0], &stages_[1], &stages_[2],
                        &stages_[3], &net_, &positions_, &velocities_, &begin_position_})
      one->resize(of_.links.size());
  }

  SubsystemInfo info() const;
  double own_step() const { return of_.own_step; }
  void end_at(double t_stop) { t_stop_ = t_stop; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  std::vector<std::string> remarks(double t_stop) const;
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  using Forces = std::vector<double>;  ///< by link

  std::size_t size() const { return of_.links.size(); }
  double length() const { return end_ - begin_; }
  bool varies() const { return !of_.accelerance_rate.empty(); }
  void read_accelerance(double node, std::span<const Signal> u);
  void check_rate(std::size_t e, double node);
  void turn_to_next(double s);
  void begin_slow_step(double t);
  void check_slow_side(double t, const Signal& position) const;
  void accelerate(std::size_t stage, double h, const double (&times)[3]);
  void take_spring(const Forces& forces, const Forces& y, const Forces& v, Forces& net) const;
  void make_up_start(double t, std::span<const Signal> u);
  void take_node(double t, std::span<const Signal> u);
  void pass_node(const OwnStep& s);
  void check_reaction(std::span<const Signal> u, double node);

  ImpulseCoupling of_;
  double t_stop_ = 0.0;
  TimeTolerance tolerance_;
  double begin_ = 0.0, end_ = 0.0;  ///< of the slow side's step [s]
  bool passed_ = false;             ///< its end, and the slow side has not been heard since
  int steps_ = 0;                   ///< own ones so far, up to degree + 1
  Accelerance accelerance_, next_;  ///< from the last node on; at the one that is taken
  std::vector<SurrogateLink> links_;
  std::vector<ReactionCheck> checks_;    ///< by link
  double worst_ = 0.0, worst_at_ = 0.0;  ///< error of a check so far, and when [s]
  std::array<Forces, 3> forces_;         ///< at begin, middle and end of a step
  std::array<Forces, 4> stages_;         ///< accelerations at the stages of a step; else scratch
  Forces net_;  ///< of a stage; once a node is passed, the means over the slow side's step
  Forces positions_, velocities_;
  Forces begin_position_;  ///< where its springs have no force: that of the start goes with the rest
  double changed_ = 0.0,
         changed_at_ = 0.0;  ///< part of A by which it changed otherwise than by its rate, and when [s]
};

SubsystemInfo Surrogate::info() const {
  SubsystemInfo info{"impulse_surrogate", {}, {}, {}, {.serializes_state = true}};
  const auto add = [&](std::vector<Port>& to, const std::string& name,
                       std::string ImpulseCoupling::Link::*unit, int derivatives) {
    for (std::size_t k = 0; k < size(); ++k)
      to.push_back(
          {size() > 1 ? name + "_" + std::to_string(k + 1) : name, of_.links[k].*unit, 1, derivatives});
  };
  add(info.inputs, "force", &ImpulseCoupling::Link::force_unit, 0);
  add(info.inputs, "position", &ImpulseCoupling::Link::displacement_unit, 0);
  const int links = static_cast<int>(size());
  for (int e = 0; varies() && e < links * links; ++e)
    info.inputs.push_back(
        {links > 1 ? "accelerance_" + std::to_string(e / links + 1) + "_" + std::to_string(e % links + 1)
                   : "accelerance",
         of_.accelerance_units[static_cast<std::size_t>(e)]});
  add(info.outputs, "displacement", &ImpulseCoupling::Link::displacement_unit, 1);
  add(info.outputs, "mean_force", &ImpulseCoupling::Link::force_unit, 0);
  for (std::size_t k = 0; k < size() && !varies(); ++k)
    info.outputs.push_back({size() > 1 ? "reaction_error_" + std::to_string(k + 1) : "reaction_error", "1"});
  for (int k = 0; k < links; ++k) info.feedthrough.push_back({k, links + k});
  return info;
}

void Surrogate::start(double t, std::span<const double> u0) {
  links_.clear(), checks_.clear(), worst_ = worst_at_ = 0.0;
  const bool hat = of_.stiffness.empty() && of_.slow_step < longest_hat * of_.fast_period;
  const ForceWindow window(hat ? ForceWindow::Kind::hat : ForceWindow::Kind::b_spline, of_.slow_step);
  for (std::size_t k = 0; k < size(); ++k) {
    begin_position_[k] = u0[size() + k], velocities_[k] = of_.links[k].velocity;
    forces_[0][k] = positions_[k] = 0.0;
  }
  accelerance_ = varies() ? Accelerance(of_.accelerance, of_.accelerance_rate) : next_;
  changed_ = changed_at_ = 0.0;
  take_spring(forces_[0], positions_, velocities_, net_);
  accelerance_.react(net_, 0.0, stages_[0]);  // what its springs accelerate
  for (std::size_t k = 0; k < size(); ++k) {
    links_.emplace_back(window, begin_position_[k], velocities_[k],
                        of_.links[k].free_acceleration - stages_[0][k]);
    if (!varies()) checks_.emplace_back(of_.links[k].free_acceleration);
  }
  tolerance_ = TimeTolerance(t);
  passed_ = false;
  steps_ = 0;
  begin_slow_step(t);
}

/// The last one ends where the run does.
void Surrogate::begin_slow_step(double t) { begin_ = t, end_ = std::min(t + of_.slow_step, t_stop_); }

/// The slow side stands at its newest sample.
void Surrogate::check_slow_side(double t, const Signal& position) const {
  const double at = position.segments().back().origin;
  if (!tolerance_.before(at, t) && !tolerance_.before(t, at)) return;
  throw Error(ErrorCode::not_supported,
              "impulse coupling: the slow side stands at " + std::to_string(at) +
                  " s where it is to stand at " + std::to_string(t) +
                  " s; allowed is an order in which the surrogate and the fast sides lead it");
}

void Surrogate::step(const OwnStep& s, std::span<const Signal> u) {
  if (passed_) take_node(s.begin, u);
  if (steps_ > 0 && steps_ <= of_.degree) make_up_start(s.begin, u);
  if (steps_ <= of_.degree) ++steps_;
  const double times[] = {s.begin, s.begin + s.length / 2.0, s.end};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < size(); ++k) forces_[i][k] = u[k].value(times[i]);
  for (std::size_t stage = 0; stage < 4; ++stage) accelerate(stage, s.length, times);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].step(s.length, {forces_[0][k], forces_[1][k], forces_[2][k]},
                   {stages_[0][k], stages_[1][k], stages_[2][k], stages_[3][k]});
  if (tolerance_.before(s.end, end_)) return;
  check_slow_side(begin_, u[size()]);
  pass_node(s);
}

/// Of the stage of the classical Runge-Kutta method, from the one before.
void Surrogate::accelerate(std::size_t stage, double h, const double (&times)[3]) {
  const std::size_t at = (stage + 1) / 2;
  const double c = stage == 0 ? 0.0 : stage == 3 ? h : 0.5 * h;
  for (std::size_t k = 0; k < size(); ++k) {
    positions_[k] = links_[k].position() - begin_position_[k] + (stage == 0 ? 0.0 : c * velocities_[k]);
    velocities_[k] = links_[k].velocity() + (stage == 0 ? 0.0 : c * stages_[stage - 1][k]);
  }
  take_spring(forces_[at], positions_, velocities_, net_);
  accelerance_.react(net_, times[at] - begin_, stages_[stage]);
  for (std::size_t k = 0; k < size(); ++k) stages_[stage][k] += links_[k].acceleration(times[at] - begin_);
}

/// The forces without those of the slow side's own springs and dampers; y from the start.
void Surrogate::take_spring(const Forces& forces, const Forces& y, const Forces& v, Forces& net) const {
  net = forces;
  if (of_.stiffness.empty()) return;
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < size(); ++k)
      net[i] -= of_.stiffness[i * size() + k] * y[k] + of_.damping[i * size() + k] * v[k];
}

void Surrogate::make_up_start(double t, std::span<const Signal> u) {
  for (std::size_t k = 0; k < size(); ++k) net_[k] = u[k].value(t) - forces_[2][k];
  accelerance_.react(net_, t - begin_, stages_[0]);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].make_up_start(steps_, of_.own_step, net_[k], stages_[0][k]);
}

/// The slow side has its spring at the mean position of its own rule, y_m = (y + y_e) / 2 - a H^2 / 12 with y_e where it
/// will come to; what that is off goes into its input. The trapezoidal rule has no such term: there a is the
/// acceleration without A F, so that its own error on the smooth motion is made up for.
void Surrogate::pass_node(const OwnStep& s) {
  for (std::size_t k = 0; k < size(); ++k) {
    const ForceIntegrals of =
        links_[k].cut_at_node(s.length, s.end - end_, forces_[0][k], forces_[2][k], length());
    stages_[0][k] = links_[k].pass(of, length(), of_.slow_step);
    positions_[k] = links_[k].mean_position() - begin_position_[k],
    velocities_[k] = links_[k].mean_velocity();
  }
  take_spring(stages_[0], positions_, velocities_, net_);
  const double middle = length() / 2.0;
  accelerance_.react(net_, middle, stages_[1]), accelerance_.react(stages_[0], middle, stages_[2]);
  for (std::size_t k = 0; k < size(); ++k) {
    SurrogateLink& link = links_[k];
    link.foresee(stages_[1][k], length());
    const double a = link.middle(length()) + stages_[1][k] - (of_.trapezoidal ? stages_[2][k] : 0.0);
    positions_[k] -= link.foreseen_mean(a, length()) - begin_position_[k],
        velocities_[k] -= link.foreseen_speed(length());
  }
  take_spring(stages_[0], positions_, velocities_, stages_[3]);
  for (std::size_t k = 0; k < size(); ++k) links_[k].set_mean_force(stages_[3][k]);
  passed_ = true;
}

void Surrogate::take_node(double t, std::span<const Signal> u) {
  const bool jumps = of_.slow_step < of_.fast_period;
  check_slow_side(end_, u[size()]);
  const double node = u[size()].segments().back().origin;
  varies() ? read_accelerance(node, u) : check_reaction(u, node);
  const Accelerance& next = varies() ? next_ : accelerance_;
  accelerance_.react_to(next, length(), net_, stages_[1]);
  for (std::size_t k = 0; k < size(); ++k) {
    const Signal& position = u[size() + k];
    links_[k].take(position.value(node), position.derivative(node), stages_[1][k], t - end_, length(),
                   of_.slow_step, jumps);
  }
  if (varies()) turn_to_next(t - end_);
  begin_slow_step(node);
  passed_ = false;
}

void Surrogate::read_accelerance(double node, std::span<const Signal> u) {
  for (std::size_t e = 0; e < size() * size(); ++e) {
    const Signal& one = u[2 * size() + e];
    next_.values()[e] = one.value(node), next_.rates()[e] = one.derivative(node);
    if (e % (size() + 1) == 0 && !(next_.values()[e] > 0.0))
      throw Error(ErrorCode::numerical, "impulse coupling: the accelerance of the slow side at its link " +
                                            std::to_string(e / size() + 1) + " is " +
                                            std::to_string(next_.values()[e]) +
                                            " at t = " + std::to_string(node) + " s; allowed is above 0");
    check_rate(e, node);
  }
}

/// A cubic has the mean of the rates at its ends, but for a third derivative.
void Surrogate::check_rate(std::size_t e, double node) {
  const double rate = 0.5 * (accelerance_.rates()[e] + next_.rates()[e]);
  const double off = std::abs(next_.values()[e] - accelerance_.values()[e] - length() * rate),
               own = std::abs(accelerance_.values()[e / size() * (size() + 1)]);
  if (off > changed_ * own) changed_ = off / own, changed_at_ = node;
}

/// From the node on, s before, the net force has accelerated otherwise.
void Surrogate::turn_to_next(double s) {
  for (std::size_t k = 0; k < size(); ++k)
    positions_[k] = links_[k].position() - begin_position_[k], velocities_[k] = links_[k].velocity();
  take_spring(forces_[2], positions_, velocities_, net_);
  accelerance_.react(net_, length(), stages_[0]), accelerance_.react(net_, length() + s, stages_[1]);
  next_.react(net_, 0.0, stages_[2]), next_.react(net_, s, stages_[3]);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].make_up(s, stages_[2][k] - stages_[0][k], stages_[3][k] - stages_[1][k]);
  std::swap(accelerance_, next_);
}

/// Before the link takes the node, and so its velocity.
void Surrogate::check_reaction(std::span<const Signal> u, double node) {
  for (std::size_t k = 0; k < size(); ++k) positions_[k] = checks_[k].change_to(links_[k].mean_force());
  accelerance_.react(positions_, 0.0, velocities_);
  for (std::size_t k = 0; k < size(); ++k) positions_[k] = links_[k].mean_force();
  accelerance_.react(positions_, 0.0, stages_[1]);
  for (std::size_t k = 0; k < size(); ++k) {
    const Signal& position = u[size() + k];
    checks_[k].take(position.derivative(node) - links_[k].rate(), length(), position.second_derivative(node),
                    stages_[1][k], velocities_[k]);
    if (const double error = checks_[k].error(); error > worst_) worst_ = error, worst_at_ = node;
  }
}

std::vector<std::string> Surrogate::remarks(double) const {
  if (changed_ > largest_change)
    return {
        "the accelerance changes otherwise than its rate says, by up to " + std::to_string(100.0 * changed_) +
        " % of it in a slow step (at t = " + std::to_string(changed_at_) +
        " s); allowed is 1 %, so it jumps, its derivative is wrong, or the slow steps are too long for it"};
  if (worst_ <= largest_reaction_error) return {};
  return {"the slow side answers the force otherwise than it does, by up to " +
          std::to_string(100.0 * worst_) + " % (at t = " + std::to_string(worst_at_) +
          " s); allowed is 0.1 %, so its effective mass is another one, or varies, "
          "and the results are off"};
}

void Surrogate::outputs(double* y) const {
  for (const SurrogateLink& link : links_) *y++ = link.position();
  for (const SurrogateLink& link : links_) *y++ = link.mean_force();
  for (const ReactionCheck& check : checks_) *y++ = check.error();
  for (const SurrogateLink& link : links_) *y++ = link.velocity();
  std::fill_n(y, size() + checks_.size(), 0.0);
}

void Surrogate::write(ByteWriter& to) const {
  to.put(begin_);
  to.put(std::uint8_t{passed_}), to.put(std::int32_t{steps_});
  for (const Forces* one : {&forces_[2], &net_})
    for (const double force : *one) to.put(force);
  accelerance_.write(to);
  for (const SurrogateLink& link : links_) link.write(to);
  for (const ReactionCheck& check : checks_) check.write(to);
  for (const double one : begin_position_) to.put(one);
  for (const double one : {worst_, worst_at_, changed_, changed_at_}) to.put(one);
}

void Surrogate::read(ByteReader& from) {
  begin_slow_step(from.take<double>());
  passed_ = from.take<std::uint8_t>() != 0, steps_ = from.take<std::int32_t>();
  for (Forces* one : {&forces_[2], &net_})
    for (double& force : *one) force = from.take<double>();
  accelerance_.read(from);
  for (SurrogateLink& link : links_) link.read(from);
  for (ReactionCheck& check : checks_) check.read(from);
  for (double& one : begin_position_) one = from.take<double>();
  for (double* one : {&worst_, &worst_at_, &changed_, &changed_at_}) *one = from.take<double>();
}

}  // namespace

std::unique_ptr<Subsystem> impulse_surrogate(ImpulseCoupling coupling) {
  return std::make_unique<FixedStep<Surrogate>>(Surrogate(std::move(coupling)));
}

}  // namespace tandem
