// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/exchanged.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "tandem/engine/compile.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {
namespace {

/// Stands where a simulation has its integrator. It takes no steps.
class Elsewhere final : public Integrator {
 public:
  void restart(System&, double, Restart) override {}
  double advance(System&, double t, double) override { return t; }
  Statistics statistics() const override { return {}; }
};

Program compiled(const Description& diagram) {
  Program program = compile(diagram);
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::not_supported,
                "diagram '" + diagram.name + "': " + what +
                    ", so nobody else can integrate it; allowed is Co-Simulation, or another block");
  };
  for (const Delay& delay : program.delays) refuse(program.named(delay.name) + " remembers a signal's past");
  if (!program.step_updates.empty()) {
    const auto slot = static_cast<std::size_t>(program.step_updates.front().to);
    refuse(program.named(program.signal_blocks[slot]) + " goes by own steps");
  }
  return program;
}

}  // namespace

Exchanged::Exchanged(const Description& diagram, double step, const SimulationSettings& settings)
    : program_(compiled(diagram)),
      simulation_(program_, &inputs_, std::make_unique<Elsewhere>(), settings),
      step_(program_.sampled() ? program_.shortest_period : step) {
  inputs_.values.resize(program_.inputs.size());
}

void Exchanged::set_input(int k, double value) {
  if (std::exchange(inputs_.values[static_cast<std::size_t>(k)], value) != value) known_ = Known::nothing;
}

void Exchanged::start(double t) {
  simulation_.start(t);
  simulation_.expect_steps(step_);
  time_ = t, known_ = Known::all;
}

void Exchanged::go_to(double t) {
  if (std::exchange(time_, t) != t) known_ = Known::nothing;
}

void Exchanged::set_states(std::span<const double> x) {
  std::copy(x.begin(), x.end(), simulation_.system().states());
  known_ = Known::nothing;
}

std::span<const double> Exchanged::states() {
  return {simulation_.system().states(), static_cast<std::size_t>(program_.states)};
}

void Exchanged::rates(double* dx) {
  System& system = simulation_.system();
  if (known_ != Known::nothing) return system.read_rates(dx);
  system.rates(time_, dx);
  known_ = Known::rates;
}

void Exchanged::evaluate() {
  if (std::exchange(known_, Known::all) != Known::all) simulation_.system().evaluate(time_);
}

double Exchanged::output(int k) {
  evaluate();
  return simulation_.output(k);
}

double Exchanged::watched(int k) {
  evaluate();
  return simulation_.system().watched_sign(k);
}

void Exchanged::arrive() {
  evaluate();
  simulation_.arrive(time_);
}

void Exchanged::act() {
  simulation_.act(time_);
  known_ = Known::all;
}

double Exchanged::next_event() { return simulation_.next_event(); }

void Exchanged::restore(double t, std::span<const double> state) {
  simulation_.restore(t, state);
  time_ = t, known_ = Known::nothing;
}

}  // namespace tandem::engine
