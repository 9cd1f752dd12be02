// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/exchanged_diagram.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "tandem/engine/compile.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {
namespace {

/// Stands where a simulation has its integrator. It takes no steps.
class NoIntegrator final : public Integrator {
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

ExchangedDiagram::ExchangedDiagram(const Description& diagram, double step,
                                   const SimulationSettings& settings)
    : program_(compiled(diagram)),
      simulation_(program_, &inputs_, std::make_unique<NoIntegrator>(), settings),
      step_(program_.sampled() ? program_.shortest_period : step) {
  inputs_.values.resize(program_.inputs.size());
}

void ExchangedDiagram::set_input(int k, double value) {
  if (std::exchange(inputs_.values[static_cast<std::size_t>(k)], value) != value) known_ = Known::nothing;
}

void ExchangedDiagram::start(double t) {
  known_ = Known::nothing;  // if that throws
  simulation_.start(t, false);
  simulation_.expect_steps(step_);
  time_ = t, known_ = Known::all;
  keep_guesses();
}

void ExchangedDiagram::go_to(double t) {
  if (std::exchange(time_, t) != t) known_ = Known::nothing;
}

void ExchangedDiagram::set_states(std::span<const double> x) {
  std::copy(x.begin(), x.end(), simulation_.system().states());
  known_ = Known::nothing;
}

std::span<const double> ExchangedDiagram::states() {
  return {simulation_.system().states(), static_cast<std::size_t>(program_.states)};
}

void ExchangedDiagram::rates(double* dx) {
  System& system = simulation_.system();
  if (known_ != Known::nothing) return system.read_rates(dx);
  as_tried().rates(time_, dx);
  known_ = Known::rates;
}

System& ExchangedDiagram::as_tried() {
  const double* guess = guesses_.data();
  for (const Loop& loop : program_.loops)
    for (const int cut : loop.cuts) simulation_.system().image()[static_cast<std::size_t>(cut)] = *guess++;
  return simulation_.system();
}

void ExchangedDiagram::keep_guesses() {
  guesses_.clear();
  for (const Loop& loop : program_.loops)
    for (const int cut : loop.cuts) guesses_.push_back(state()[static_cast<std::size_t>(cut)]);
}

void ExchangedDiagram::evaluate() {
  if (known_ == Known::all) return;
  System& system = simulation_.system();
  std::exchange(known_, Known::nothing) == Known::rates ? system.evaluate_rest() : as_tried().evaluate(time_);
  known_ = Known::all;
}

double ExchangedDiagram::output(int k) {
  evaluate();
  return simulation_.output(k);
}

double ExchangedDiagram::watched(int k) {
  evaluate();
  return simulation_.system().watched_sign(k);
}

void ExchangedDiagram::arrive() {
  evaluate();
  simulation_.arrive(time_);
  keep_guesses();
}

void ExchangedDiagram::act() {
  if (std::exchange(known_, Known::nothing) == Known::nothing) as_tried();
  simulation_.act(time_);
  known_ = Known::all;
  keep_guesses();
}

double ExchangedDiagram::next_event() { return simulation_.next_event(); }

void ExchangedDiagram::restore(double t, std::span<const double> state, std::span<const double> guesses,
                               Known known) {
  simulation_.restore(t, state);
  guesses_.assign(guesses.begin(), guesses.end());
  time_ = t, known_ = known;
}

}  // namespace tandem::engine
