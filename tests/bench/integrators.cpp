// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Steps of oscillators as compiled diagrams, beside the same integrator on functions written by hand.
#include <arkode/arkode_erkstep.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>

#include <array>
#include <memory>

#include "bench/bench.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::bench {
namespace {

constexpr double pendulum_step = 1e-3;
constexpr int most_states = 100;

/// So many oscillators x'' = -x; state 2k is the k-th x, 2k + 1 its velocity.
engine::Description oscillators(int states) {
  engine::Description d{"oscillators", {}, {}, {}, {}};
  for (int k = 0; k < states / 2; ++k) {
    const auto x = fmt::format("x{}", k), v = fmt::format("v{}", k), a = fmt::format("a{}", k);
    d.blocks.push_back({x, "integrator", {{"input", v}, {"initial", 1.0}}});
    d.blocks.push_back({v, "integrator", {{"input", a}}});
    d.blocks.push_back({a, "gain", {{"input", x}, {"gain", -1.0}}});
    d.outputs.push_back({x, "m", x});
  }
  return d;
}

/// x' as the diagram has it, written by hand.
void rates(int n, const double* x, double* dx) {
  for (int k = 0; k < n; k += 2) dx[k] = x[k + 1], dx[k + 1] = -x[k];
}

/// The classical method on any function, as a textbook has it.
struct BareRk4 {
  using Rates = void (*)(int, const double*, double*);
  explicit BareRk4(int states) : n(states) {
    for (int k = 0; k < n; k += 2) x[k] = 1.0;
  }
  void step() {
    std::array<double, most_states> k1, k2, k3, k4, y;
    f(n, x.data(), k1.data());
    for (int i = 0; i < n; ++i) y[i] = x[i] + 0.5 * pendulum_step * k1[i];
    f(n, y.data(), k2.data());
    for (int i = 0; i < n; ++i) y[i] = x[i] + 0.5 * pendulum_step * k2[i];
    f(n, y.data(), k3.data());
    for (int i = 0; i < n; ++i) y[i] = x[i] + pendulum_step * k3[i];
    f(n, y.data(), k4.data());
    for (int i = 0; i < n; ++i) x[i] += pendulum_step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  int n;
  Rates volatile f = rates;  // volatile: not known to the compiler, as an integrator knows no function
  std::array<double, most_states> x{};
};

/// ERKStep as its manual has it, with the tolerances of tandem's default.
class BareErkStep {
 public:
  explicit BareErkStep(int states) {
    SUNContext_Create(nullptr, &context_);
    x_ = N_VNew_Serial(states, context_);
    for (int k = 0; k < states; ++k) N_VGetArrayPointer(x_)[k] = k % 2 == 0 ? 1.0 : 0.0;
    memory_ = ERKStepCreate(function, 0.0, x_, context_);
    const engine::AdaptiveSettings settings;
    ERKStepSStolerances(memory_, settings.relative_tolerance, settings.absolute_tolerance);
    ERKStepSetUserData(memory_, this);
  }
  ~BareErkStep() {
    ERKStepFree(&memory_);
    N_VDestroy(x_);
    SUNContext_Free(&context_);
  }
  BareErkStep(const BareErkStep&) = delete;
  BareErkStep& operator=(const BareErkStep&) = delete;

  void step() {
    double t = 0.0;
    const double end = static_cast<double>(++steps_) * pendulum_step;
    ERKStepSetStopTime(memory_, end);
    ERKStepEvolve(memory_, end, x_, &t, ARK_NORMAL);
  }

 private:
  static int function(double, N_Vector x, N_Vector dx, void*) {
    rates(static_cast<int>(N_VGetLength(x)), N_VGetArrayPointer(x), N_VGetArrayPointer(dx));
    return 0;
  }
  SUNContext context_ = nullptr;
  N_Vector x_ = nullptr;
  void* memory_ = nullptr;
  long steps_ = 0;
};

/// A diagram by one of tandem's integrators.
class DiagramSteps {
 public:
  DiagramSteps(int states, const std::string& integrator)
      : program_(engine::compile(oscillators(states))),
        simulation_(program_, nullptr, engine::make_integrator({.name = integrator})) {
    simulation_.start(0.0);
  }
  void step() {
    const double end = static_cast<double>(++steps_) * pendulum_step;
    while (simulation_.time() < end) simulation_.step(end);
  }

 private:
  engine::Program program_;
  engine::Simulation simulation_;
  long steps_ = 0;
};

template <class Stepper, class... Arguments>
Timing timing_of(const std::string& name, const Arguments&... arguments) {
  const auto stepper = std::make_shared<Stepper>(arguments...);
  return {name, [stepper](benchmark::State& state) {
            for ([[maybe_unused]] auto _ : state) stepper->step();
          }};
}

}  // namespace

Table integrators() {
  const std::vector<int> sizes = {2, 10, most_states};
  const auto name = [](const std::string& what, int states) { return fmt::format("{}/{}", what, states); };
  std::vector<Timing> timings;
  for (const int n : sizes) {
    timings.push_back(timing_of<BareRk4>(name("bare_rk4", n), n));
    timings.push_back(timing_of<BareErkStep>(name("bare_erkstep", n), n));
    for (const auto& integrator : engine::integrator_names())
      timings.push_back(timing_of<DiagramSteps>(name(integrator, n), n, integrator));
  }
  auto seconds = measure(timings, 20, 0.01);
  Table table({"integrator", "states", "ns_per_step", "bare_ns", "ratio"});
  for (const int n : sizes)
    for (const auto& integrator : engine::integrator_names()) {
      const double ours = seconds[name(integrator, n)], bare = seconds[name("bare_" + integrator, n)];
      table.add({integrator, std::to_string(n), fmt::format("{:.1f}", 1e9 * ours),
                 bare > 0.0 ? fmt::format("{:.1f}", 1e9 * bare) : "",
                 bare > 0.0 ? fmt::format("{:.2f}", ours / bare) : ""});
    }
  return table;
}

}  // namespace tandem::bench
