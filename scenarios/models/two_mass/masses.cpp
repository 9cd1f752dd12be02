// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/masses.hpp"

#include <array>

#include "tandem/error.hpp"

namespace tandem::two_mass {

FastMass::FastMass(const Model& model, Options options) : model_(model), options_(options) {
  if (options.carried_mass < 0.0 || options.carried_mass >= model.m2)
    throw Error(ErrorCode::invalid_argument,
                "two_mass: carried_mass is " + std::to_string(options.carried_mass) +
                    " kg; allowed is 0 to below m2 = " + std::to_string(model.m2) + " kg");
}

SubsystemInfo FastMass::info() const {
  SubsystemInfo info{"two_mass.fast",
                     {{"x2", "m"}},
                     {{"x1", "m", 1, 2}, {"v1", "m/s", 1, 1}},
                     {},
                     {.reactive_inputs = true, .serializes_state = true}};
  if (!options_.force) return info;
  info.outputs.push_back({"F", "N"});
  info.feedthrough.push_back({2, 0});
  if (options_.carried_mass > 0.0) {
    info.inputs.push_back({"a2", "m/s^2"});
    info.feedthrough.push_back({2, 1});
  }
  return info;
}

double FastMass::acceleration(double x1, double x2) const {
  return (model_.k2 * x2 - (model_.k1 + model_.k2) * x1) / model_.m1;
}

double FastMass::force(double x1, double x2, double a2) const {
  return model_.k2 * (x1 - x2) - options_.carried_mass * a2;
}

void FastMass::take_inputs(double x2, double a2) {
  a1_ = acceleration(x1_, x2);
  force_ = force(x1_, x2, a2);
}

/// Its states with those of a reaction, as ClassicalSteps sees them.
struct FastMass::Joint {
  FastMass& mass;
  std::span<const Signal> u;
  double begin;  ///< [s]

  double x2(double t) const { return u[0].value(t, mass.joint_.data() + 2); }
  double a2(double t) const { return u.size() > 1 ? u[1].value(t, mass.joint_.data() + 2) : 0.0; }
  int size() const { return static_cast<int>(mass.joint_.size()); }
  double* states() const { return mass.joint_.data(); }
  void rates(double t, double* dx) const {
    const double* const x = mass.joint_.data();
    const double at = x2(t), y[] = {x[0], x[1], mass.force(x[0], at, a2(t))};
    dx[0] = x[1], dx[1] = mass.acceleration(x[0], at);
    tandem_reaction_rates(mass.reaction_, t, x + 2, y, dx + 2);
  }
  void read_rates(double* dx) const { rates(begin, dx); }
  void evaluate(double) const {}
  void evaluate_again(double) const {}
  int changed() const { return -1; }
  double watched(int) const { return 0.0; }
};

void FastMass::react(const Reaction* reaction) {
  reaction_ = reaction;
  if (!reaction) return;
  joint_.resize(2);
  joint_.insert(joint_.end(), reaction->begin, reaction->begin + reaction->states);
  steps_.resize(static_cast<int>(joint_.size()));
}

void FastMass::step_with_reaction(const OwnStep& s, std::span<const Signal> u) {
  joint_[0] = x1_, joint_[1] = v1_;
  Joint joint{*this, u, s.begin};
  steps_.advance(joint, s.begin, s.end, false);
  x1_ = joint_[0], v1_ = joint_[1];
  take_inputs(joint.x2(s.end), joint.a2(s.end));
}

void FastMass::start(double t, std::span<const double> u0) {
  const Motion m = model_.exact(t);
  x1_ = m.x1;
  v1_ = m.v1;
  take_inputs(u0[0], u0.size() > 1 ? u0[1] : 0.0);
}

void FastMass::step(const OwnStep& s, std::span<const Signal> u) {
  if (reaction_) return step_with_reaction(s, u);
  const double h = s.length, half = 0.5 * h;
  const double begin = u[0].value(s.begin), middle = u[0].value(s.begin + half), end = u[0].value(s.end);
  const double k1 = acceleration(x1_, begin);
  const double k2 = acceleration(x1_ + half * v1_, middle);
  const double k3 = acceleration(x1_ + half * (v1_ + half * k1), middle);
  const double k4 = acceleration(x1_ + h * (v1_ + half * k2), end);
  x1_ += h * (v1_ + h / 6.0 * (k1 + k2 + k3));
  v1_ += h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
  take_inputs(end, u.size() > 1 ? u[1].value(s.end) : 0.0);
}

void FastMass::outputs(double* y) const {
  if (!options_.force) {
    const double row[] = {x1_, v1_, v1_, a1_, a1_, 0.0};
    std::copy(std::begin(row), std::end(row), y);
  } else {
    const double row[] = {x1_, v1_, force_, v1_, a1_, 0.0, a1_, 0.0, 0.0};
    std::copy(std::begin(row), std::end(row), y);
  }
}

std::optional<std::vector<StateName>> FastMass::states() const {
  return std::vector<StateName>{{"x1", "m"}, {"v1", "m/s"}};
}
void FastMass::get_states(std::span<double> x) const { x[0] = x1_, x[1] = v1_; }
void FastMass::set_states(std::span<const double> x) { x1_ = x[0], v1_ = x[1]; }

void FastMass::write(ByteWriter& to) const { to.put_doubles(std::array{x1_, v1_, a1_, force_}); }

void FastMass::read(ByteReader& from) {
  x1_ = from.take<double>();
  v1_ = from.take<double>();
  a1_ = from.take<double>();
  force_ = from.take<double>();
}

SlowMass::SlowMass(const Model& model, Options options)
    : model_(model),
      options_(options),
      gain_(options.force ? 1.0 : model.k2),
      stiffness_(options.force ? model.k3 : model.k2 + model.k3),
      mass_(model.m2 - options.carried_mass) {
  if (options.carried_mass < 0.0 || mass_ <= 0.0)
    throw Error(ErrorCode::invalid_argument,
                "two_mass: carried_mass is " + std::to_string(options.carried_mass) +
                    " kg; allowed is 0 to below m2 = " + std::to_string(model.m2) + " kg");
}

SubsystemInfo SlowMass::info() const {
  SubsystemInfo info{"two_mass.slow",
                     {{"x1", "m"}},
                     {{"x2", "m", 1, 2}, {"v2", "m/s", 1, 1}},
                     {},
                     {.serializes_state = true}};
  if (!options_.force) return info;
  info.inputs[0] = {"F", "N"};
  info.outputs.push_back({"a2", "m/s^2"});
  info.feedthrough.push_back({2, 0});
  return info;
}

void SlowMass::start(double t, std::span<const double> u0) {
  const Motion m = model_.exact(t);
  x2_ = m.x2;
  v2_ = m.v2;
  a2_ = (gain_ * u0[0] - stiffness_ * x2_) / mass_;
}

void SlowMass::step(const OwnStep& s, std::span<const Signal> u) {
  const double h = s.length;
  const double before =
      options_.reuse_acceleration ? a2_ : (gain_ * u[0].value(s.begin) - stiffness_ * x2_) / mass_;
  const double push = gain_ * u[0].value(s.end);
  x2_ = (x2_ + h * v2_ + 0.25 * h * h * (before + push / mass_)) / (1.0 + 0.25 * h * h * stiffness_ / mass_);
  a2_ = (push - stiffness_ * x2_) / mass_;
  v2_ += 0.5 * h * (before + a2_);
}

void SlowMass::outputs(double* y) const {
  if (!options_.force) {
    const double row[] = {x2_, v2_, v2_, a2_, a2_, 0.0};
    std::copy(std::begin(row), std::end(row), y);
  } else {
    const double row[] = {x2_, v2_, a2_, v2_, a2_, 0.0, a2_, 0.0, 0.0};
    std::copy(std::begin(row), std::end(row), y);
  }
}

std::optional<std::vector<StateName>> SlowMass::states() const {
  std::vector<StateName> names{{"x2", "m"}, {"v2", "m/s"}};
  if (options_.reuse_acceleration) names.push_back({"a2", "m/s^2"});
  return names;
}
void SlowMass::get_states(std::span<double> x) const {
  x[0] = x2_, x[1] = v2_;
  if (options_.reuse_acceleration) x[2] = a2_;
}
void SlowMass::set_states(std::span<const double> x) {
  x2_ = x[0], v2_ = x[1];
  if (options_.reuse_acceleration) a2_ = x[2];
}

void SlowMass::write(ByteWriter& to) const { to.put_doubles(std::array{x2_, v2_, a2_}); }

void SlowMass::read(ByteReader& from) {
  x2_ = from.take<double>();
  v2_ = from.take<double>();
  a2_ = from.take<double>();
}

SubsystemInfo BothMasses::info() const {
  return {"two_mass.both",
          {},
          {{"x1", "m"}, {"v1", "m/s"}, {"x2", "m"}, {"v2", "m/s"}},
          {},
          {.serializes_state = true}};
}

void BothMasses::start(double t, std::span<const double>) { state_ = model_.exact(t); }

void BothMasses::step(const OwnStep& s, std::span<const Signal>) {
  const auto rate = [this](const Motion& m) {
    return Motion{m.v1, (model_.k2 * m.x2 - (model_.k1 + model_.k2) * m.x1) / model_.m1, m.v2,
                  (model_.k2 * m.x1 - (model_.k2 + model_.k3) * m.x2) / model_.m2};
  };
  const auto plus = [](const Motion& m, double h, const Motion& k) {
    return Motion{m.x1 + h * k.x1, m.v1 + h * k.v1, m.x2 + h * k.x2, m.v2 + h * k.v2};
  };
  const double h = s.length;
  const Motion k1 = rate(state_), k2 = rate(plus(state_, 0.5 * h, k1)), k3 = rate(plus(state_, 0.5 * h, k2)),
               k4 = rate(plus(state_, h, k3));
  state_ = plus(plus(plus(plus(state_, h / 6.0, k1), h / 3.0, k2), h / 3.0, k3), h / 6.0, k4);
}

void BothMasses::outputs(double* y) const {
  y[0] = state_.x1, y[1] = state_.v1, y[2] = state_.x2, y[3] = state_.v2;
}

std::optional<std::vector<StateName>> BothMasses::states() const {
  return std::vector<StateName>{{"x1", "m"}, {"v1", "m/s"}, {"x2", "m"}, {"v2", "m/s"}};
}
void BothMasses::get_states(std::span<double> x) const { outputs(x.data()); }
void BothMasses::set_states(std::span<const double> x) { state_ = {x[0], x[1], x[2], x[3]}; }

void BothMasses::write(ByteWriter& to) const {
  to.put_doubles(std::array{state_.x1, state_.v1, state_.x2, state_.v2});
}

void BothMasses::read(ByteReader& from) {
  state_.x1 = from.take<double>();
  state_.v1 = from.take<double>();
  state_.x2 = from.take<double>();
  state_.v2 = from.take<double>();
}

SubsystemInfo ExactMasses::info() const {
  return {"two_mass.exact",
          {},
          {{"x1", "m", 1, 2}, {"v1", "m/s", 1, 1}, {"x2", "m", 1, 2}, {"v2", "m/s", 1, 1}},
          {},
          {.serializes_state = true}};
}

void ExactMasses::outputs(double* y) const {
  const Motion m = model_.exact(t_);
  const double a1 = (model_.k2 * m.x2 - (model_.k1 + model_.k2) * m.x1) / model_.m1;
  const double a2 = (model_.k2 * m.x1 - (model_.k2 + model_.k3) * m.x2) / model_.m2;
  const double row[] = {m.x1, m.v1, m.x2, m.v2, m.v1, a1, m.v2, a2, a1, 0.0, a2, 0.0};
  std::copy(std::begin(row), std::end(row), y);
}

void ExactMasses::write(ByteWriter& to) const { to.put_doubles(std::array{t_}); }
void ExactMasses::read(ByteReader& from) { t_ = from.take<double>(); }

void add_builtins(Builtins& builtins) {
  const auto add = [&](const char* name, const Words& besides, const auto& make) {
    builtins.models[std::string("two_mass.") + name] = {
        Settings::words() + besides, [make](const Address&, Parameters& p) -> std::unique_ptr<Subsystem> {
          return std::make_unique<FixedStep<decltype(make(Model({}), p))>>(make(Model(Settings::from(p)), p));
        }};
  };
  const Words force = words_by(Setter::client, {"carried_mass"});
  add("fast", {}, [](const Model& m, Parameters&) { return FastMass(m, {}); });
  add("slow", words_by(Setter::client, {"reuse_acceleration"}), [](const Model& m, Parameters& p) {
    return SlowMass(m, {.reuse_acceleration = p.flag("reuse_acceleration", false)});
  });
  add("fast_force", force, [](const Model& m, Parameters& p) {
    return FastMass(m, {true, p.number("carried_mass", 0.0)});
  });
  add("slow_force", force, [](const Model& m, Parameters& p) {
    return SlowMass(m, {true, p.number("carried_mass", 0.0)});
  });
  add("both", {}, [](const Model& m, Parameters&) { return BothMasses(m); });
  add("exact", {}, [](const Model& m, Parameters&) { return ExactMasses(m); });
}

}  // namespace tandem::two_mass
