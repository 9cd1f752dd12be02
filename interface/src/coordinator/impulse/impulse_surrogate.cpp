// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/impulse/impulse_surrogate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "surrogate_link.hpp"
#include "tandem/error.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem {
namespace {

/// So many fast periods a step of the slow side may be long for the window of the fewest steps.
constexpr double longest_hat = 0.65;

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(ErrorCode::invalid_argument, "impulse coupling: " + what);
}

class Surrogate {
 public:
  explicit Surrogate(ImpulseCoupling coupling) : of_(std::move(coupling)) {
    const auto above_zero = [](double one) { return std::isfinite(one) && one > 0.0; };
    require(above_zero(of_.own_step) && above_zero(of_.slow_step) && above_zero(of_.fast_period),
            "own steps and the fast period are to be above 0 s");
    require(of_.slow_step >= of_.own_step, "the slow side's own step is shorter than the fast side's");
    require(!of_.links.empty() && of_.accelerance.size() == of_.links.size() * of_.links.size(),
            "the accelerance is to be a matrix of all links");
    for (auto& forces : forces_) forces.resize(of_.links.size());
    reactions_ = forces_;
  }

  SubsystemInfo info() const;
  double own_step() const { return of_.own_step; }
  void end_at(double t_stop) { t_stop_ = t_stop; }
  void start(double t, std::span<const double> u0);
  void step(const OwnStep& s, std::span<const Signal> u);
  void outputs(double* y) const;
  void write(ByteWriter& to) const;
  void read(ByteReader& from);

 private:
  using Forces = std::vector<double>;  ///< by link

  std::size_t size() const { return of_.links.size(); }
  double length() const { return end_ - begin_; }
  void react(const Forces& forces, Forces& accelerations) const;
  void begin_slow_step();
  void make_up_start(double t, std::span<const Signal> u);
  void take_node(double t, std::span<const Signal> u);
  void pass_node(const OwnStep& s);

  ImpulseCoupling of_;
  double t_stop_ = 0.0;
  TimeGrid slow_;
  double begin_ = 0.0, end_ = 0.0;  ///< of the slow side's step [s]
  bool passed_ = false;             ///< its end, and the slow side has not been heard since
  int steps_ = 0;                   ///< own ones so far, up to 4
  std::vector<SurrogateLink> links_;
  std::array<Forces, 3> forces_, reactions_;  ///< at begin, middle and end of a step
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
  add(info.outputs, "displacement", &ImpulseCoupling::Link::displacement_unit, 1);
  add(info.outputs, "mean_force", &ImpulseCoupling::Link::force_unit, 0);
  const int links = static_cast<int>(size());
  for (int k = 0; k < links; ++k) info.feedthrough.push_back({k, links + k});
  return info;
}

void Surrogate::start(double t, std::span<const double> u0) {
  links_.clear();
  const bool hat = of_.slow_step < longest_hat * of_.fast_period;
  const ForceWindow window(hat ? ForceWindow::Kind::hat : ForceWindow::Kind::b_spline, of_.slow_step);
  for (std::size_t k = 0; k < size(); ++k)
    links_.emplace_back(window, u0[size() + k], of_.links[k].velocity, of_.links[k].free_acceleration);
  slow_ = TimeGrid(t, of_.slow_step);
  passed_ = false;
  steps_ = 0;
  begin_slow_step();
}

/// The last one ends where the run does.
void Surrogate::begin_slow_step() {
  begin_ = slow_.time(), end_ = slow_.fits(t_stop_) ? slow_.next() : t_stop_;
}

void Surrogate::react(const Forces& forces, Forces& accelerations) const {
  for (std::size_t i = 0; i < size(); ++i) {
    accelerations[i] = 0.0;
    for (std::size_t k = 0; k < size(); ++k) accelerations[i] += of_.accelerance[i * size() + k] * forces[k];
  }
}

void Surrogate::step(const OwnStep& s, std::span<const Signal> u) {
  if (passed_) take_node(s.begin, u);
  if (steps_ > 0 && steps_ < 4) make_up_start(s.begin, u);
  if (steps_ < 4) ++steps_;
  const double times[] = {s.begin, s.begin + s.length / 2.0, s.end};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < size(); ++k) forces_[i][k] = u[k].value(times[i]);
    react(forces_[i], reactions_[i]);
  }
  for (std::size_t k = 0; k < size(); ++k) {
    double force[3], acceleration[3];
    for (std::size_t i = 0; i < 3; ++i)
      force[i] = forces_[i][k],
      acceleration[i] = reactions_[i][k] + links_[k].acceleration(times[i] - begin_);
    links_[k].step(s.length, force, acceleration);
  }
  if (!slow_.tolerance().before(s.end, end_)) pass_node(s);
}

void Surrogate::make_up_start(double t, std::span<const Signal> u) {
  for (std::size_t k = 0; k < size(); ++k) forces_[0][k] = u[k].value(t) - forces_[2][k];
  react(forces_[0], reactions_[0]);
  for (std::size_t k = 0; k < size(); ++k)
    links_[k].make_up_start(steps_, of_.own_step, forces_[0][k], reactions_[0][k]);
}

void Surrogate::pass_node(const OwnStep& s) {
  for (std::size_t k = 0; k < size(); ++k) {
    const ForceIntegrals of = links_[k].cut_at_node(s.length, s.end - end_, forces_[0][k], forces_[2][k]);
    links_[k].pass(of, length(), of_.slow_step);
    forces_[0][k] = links_[k].mean_force();
  }
  react(forces_[0], reactions_[0]);
  for (std::size_t k = 0; k < size(); ++k) links_[k].foresee(reactions_[0][k], length());
  passed_ = true;
}

void Surrogate::take_node(double t, std::span<const Signal> u) {
  const bool jumps = of_.slow_step < of_.fast_period;
  for (std::size_t k = 0; k < size(); ++k) forces_[0][k] = links_[k].mean_force();
  react(forces_[0], reactions_[0]);
  for (std::size_t k = 0; k < size(); ++k) {
    const Signal& position = u[size() + k];
    links_[k].take(position.value(end_), position.derivative(end_), reactions_[0][k], t - end_, length(),
                   of_.slow_step, jumps);
  }
  slow_.step();
  begin_slow_step();
  passed_ = false;
}

void Surrogate::outputs(double* y) const {
  for (const SurrogateLink& link : links_) *y++ = link.position();
  for (const SurrogateLink& link : links_) *y++ = link.mean_force();
  for (const SurrogateLink& link : links_) *y++ = link.velocity();
  std::fill_n(y, size(), 0.0);
}

void Surrogate::write(ByteWriter& to) const {
  slow_.write(to);
  to.put(std::uint8_t{passed_}), to.put(std::int32_t{steps_});
  for (const double force : forces_[2]) to.put(force);
  for (const SurrogateLink& link : links_) link.write(to);
}

void Surrogate::read(ByteReader& from) {
  slow_.read(from);
  passed_ = from.take<std::uint8_t>() != 0, steps_ = from.take<std::int32_t>();
  for (double& force : forces_[2]) force = from.take<double>();
  begin_slow_step();
  for (SurrogateLink& link : links_) link.read(from);
}

}  // namespace

std::unique_ptr<Subsystem> impulse_surrogate(ImpulseCoupling coupling) {
  return std::make_unique<FixedStep<Surrogate>>(Surrogate(std::move(coupling)));
}

}  // namespace tandem
