// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "kart/tyre_element.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::test {

inline constexpr double degrees = 180.0 / std::numbers::pi;

/// The text of a file of scenarios/kart with words replaced wherever they are.
inline std::string kart_text(const std::string& name,
                             const std::vector<std::pair<std::string, std::string>>& replace = {}) {
  std::ifstream in(std::string(TANDEM_SOURCE_DIR) + "/scenarios/kart/" + name + ".toml");
  std::stringstream all;
  all << in.rdbuf();
  std::string text = all.str();
  for (const auto& [from, to] : replace)
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
      text.replace(at, from.size(), to);
  return text;
}

/// What makes the tyres have no lateral force, as in the prototype that the specification was measured with.
inline const std::vector<std::pair<std::string, std::string>> without_lateral = {
    {"kind = \"tyre\"\n", "kind = \"tyre\"\nlateral = false\n"}};

/// Tyres as printed: the force along a wheel acts on the ground below its centre.
inline const std::vector<std::pair<std::string, std::string>> printed_lever = {
    {"lever = { value = \"radius\"", "lever = { value = \"height\""}};

inline mbs::Description kart(const std::string& text) {
  return mbs::read_mechanism("kart", text, kart::element_kinds());
}

inline int entity(const mbs::Mechanism& m, const std::string& name) {
  const auto& all = m.description().entities;
  for (std::size_t e = 0; e < all.size(); ++e)
    if (all[e].name == name) return static_cast<int>(e);
  throw Error(ErrorCode::internal, "no point or vector " + name);
}

inline Eigen::Vector3d place(const mbs::Mechanism& m, const mbs::State& s, const std::string& name) {
  return s.q.segment<3>(m.coordinate(entity(m, name)));
}

/// How fast the springs of a file grow longer [m/s], and what their dampers take of it [W].
inline double damping_loss(const mbs::Mechanism& m, const mbs::State& s) {
  const int size = m.description().dimension;
  double power = 0.0;
  for (const mbs::Spring& spring : m.description().springs) {
    double rate = 0.0;
    if (spring.relative >= 0) {
      rate = s.v[m.numbering().relative[static_cast<std::size_t>(spring.relative)]];
    } else {
      const int from = m.coordinate(spring.points.from), to = m.coordinate(spring.points.to);
      const Eigen::VectorXd edge = s.q.segment(to, size) - s.q.segment(from, size);
      rate = edge.dot(s.v.segment(to, size) - s.v.segment(from, size)) / edge.norm();
    }
    power += spring.damping.at(0) * rate * rate;
  }
  return power;
}

/// Drives an input by a function of time.
inline void set_input(mbs::Description& d, const std::string& name, std::function<double(double)> value) {
  for (mbs::Input& input : d.inputs)
    if (input.name == name)
      input.function = [value](double t) { return mbs::InputValue{value(t), 0.0, 0.0}; };
}

/// A kart that takes steps.
class KartRun {
 public:
  KartRun(mbs::Description d, double h, const mbs::StepperSettings& settings = {})
      : mechanism(std::move(d)), outputs(mechanism), h_(h), stepper_(mbs::make_stepper(mechanism, settings)) {
    state = mbs::initial_state(mechanism, 0.0);
    stepper_->start(state);
    outputs.start(state);
  }
  void step() {
    ++steps_;
    stepper_->step(state, h_, static_cast<double>(steps_) * h_);
  }
  std::map<std::string, double> all_outputs() {
    std::vector<double> y(static_cast<std::size_t>(outputs.size()));
    outputs.evaluate(state, y.data());
    std::map<std::string, double> all;
    for (int k = 0; k < outputs.size(); ++k) all[outputs.name(k)] = y[static_cast<std::size_t>(k)];
    return all;
  }
  double output(const std::string& name) { return all_outputs().at(name); }

  mbs::Mechanism mechanism;
  mbs::Outputs outputs;
  mbs::State state;

 private:
  double h_;
  long steps_ = 0;
  std::unique_ptr<mbs::Stepper> stepper_;
};

}  // namespace tandem::test
