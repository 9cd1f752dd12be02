// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The stepping loop allocates nothing once it runs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "c_models.h"
#include "counted_malloc.hpp"
#include "driven_pendulum.hpp"
#include "four_bar/linkage.hpp"
#include "pushed_mass.hpp"
#include "pushed_pendulum.hpp"
#include "relay_models.hpp"
#include "run_bench.hpp"
#include "scheme.hpp"
#include "scratch.hpp"
#include "solver_bench.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "wave.hpp"

#if TANDEM_OWN_MALLOC
namespace tandem::test {
namespace {

/// Allocations in some rounds, after enough of them to have settled.
std::int64_t allocations_in(RunBench& bench, int rounds = 10'000) {
  Coordinator& run = bench.make(1e9);
  run.initialize();
  for (int k = 0; k < 300; ++k) run.round();
  allocations = 0;
  counting = true;
  for (int k = 0; k < rounds; ++k) run.round();
  counting = false;
  return allocations;
}

TEST(NoAllocation, TheCountSeesAnAllocation) {
  allocations = 0;
  counting = true;
  double* volatile one = new double(1.0);  // volatile, or it may be optimized away
  std::vector<double>* volatile two = new std::vector<double>(100);
  counting = false;
  EXPECT_GE(allocations, 3);
  delete one;
  delete two;
}

TEST(NoAllocation, InEverySchedule) {
  for (const double ratio : {1.0, 3.0, 30.7, std::numbers::sqrt2})
    for (const Scheme& scheme : all_schemes()) {
      FixedStep<Wave> fast(Wave(0.1)), slow(Wave(0.1 * ratio));
      RunBench bench;
      bench.add("fast", fast).add("slow", slow).schedule(scheme.schedule);
      bench.connect("slow.y", "fast.u", scheme.to_fast).connect("fast.y", "slow.u", scheme.to_slow);
      bench.coordination.order = {"slow", "fast"};
      EXPECT_EQ(allocations_in(bench), 0) << scheme.name() << " at ratio " << ratio;
      EXPECT_TRUE(std::isfinite(fast.model().heard() + slow.model().heard()));
    }
}

/// It switches, and the integral goes back to where it does.
TEST(NoAllocation, InAModelInC) {
  CSubsystem integral(c_integral(), ""), relay(c_switch(), "");
  RunBench bench;
  bench.add("integral", integral).add("relay", relay).schedule("slowest-first");
  bench.connect("integral.x", "relay.x", "lagrange3").connect("relay.r", "integral.u", "");
  EXPECT_EQ(allocations_in(bench), 0);
  Coordinator& run = bench.make(60.0);
  run.run();
  EXPECT_NE(run.notes().back().find("went back"), std::string::npos) << run.notes().back();
}

/// Rounds and what is between them, with results written to a file.
TEST(NoAllocation, WithARecorder) {
  const Scratch folder;
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    FixedStep<Wave> fast(Wave(0.1)), slow(Wave(0.37));
    RunBench bench;
    bench.add("fast", fast).add("slow", slow).schedule(schedule);
    bench.connect("slow.y", "fast.u", "lagrange3").connect("fast.y", "slow.u", "lagrange3");
    Coordinator& run = bench.make(1e9);
    tandem::Recording what;
    what.directory = folder.path();
    Recorder recorder(run, what);
    run.observe(&recorder);
    run.initialize();
    const auto rounds = [&](int count) {
      for (int k = 0; k < count; ++k) run.round(), recorder.between_rounds();
    };
    rounds(40'000);  // the memory of both has been full and was written
    allocations = 0;
    counting = true;
    rounds(10'000);
    counting = false;
    EXPECT_EQ(allocations, 0) << schedule;
    EXPECT_GT(std::filesystem::file_size(folder.path() / "results.csv"), 100'000U);
  }
}

TEST(NoAllocation, InSumsAndLags) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const Lag lag : {Lag::none, Lag::memory, Lag::delay}) {
      FixedStep<Wave> a(Wave(0.1)), b(Wave(0.25)), c(Wave(0.77));
      RunBench bench;
      bench.add("a", a).add("b", b).add("c", c).schedule(schedule);
      bench.topology.connect(added(connection("a.y", "c.u", "lagrange3", lag)));
      bench.topology.connect(added(connection("b.y", "c.u", "hermite")));
      bench.connect("c.y", "a.u", "lagrange2").connect("c.y", "b.u", "least_squares2_4", lag);
      EXPECT_EQ(allocations_in(bench), 0) << schedule;
    }
}

/// Takes steps from 0.01 to 0.19 s, over and over.
class Restless final : public Subsystem {
 public:
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t, double, std::span<const double>, Samples& y) override {
    y.append(time_ = t)[0] = 0.0;
    return clock();
  }
  Clock advance(double t_limit, bool, std::span<const Signal>, Samples& y) override {
    for (; !y.full() && next() <= t_limit; ++k_) {
      time_ = next();
      y.append(time_)[0] = std::sin(time_);
    }
    return clock();
  }

 private:
  double next() const { return time_ + 0.1 + 0.09 * std::sin(static_cast<double>(k_ % 60)); }
  Clock clock() const { return {time_, next(), Stop::limit}; }
  SubsystemInfo info_{"restless", {{"u", "1"}}, {{"y", "1"}}, {}, {.chooses_step = true}};
  double time_ = 0.0;
  std::int64_t k_ = 0;
};

TEST(NoAllocation, WithStepsThatVary) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const double step : {0.05, 1.0, 10.0}) {
      Restless restless;
      FixedStep<Wave> wave{Wave(step)};
      RunBench bench;
      bench.add("restless", restless).add("wave", wave).schedule(schedule);
      bench.connect("restless.y", "wave.u", "lagrange1").connect("wave.y", "restless.u", "lagrange3");
      EXPECT_EQ(allocations_in(bench), 0) << schedule << " with steps of " << step;
    }
}

/// A ring, so that columns have fill; each width of the band, and each of the prepared solver's blocks.
TEST(NoAllocation, InOurOwnSolvers) {
  using test::SolverBench;
  for (const char* name : {"band", "prepared"})
    for (const int width : {1, 2, 4, 8, 9, 20}) {
      Eigen::MatrixXd a = Eigen::MatrixXd::Identity(50, 50) * 4.0 * width;
      for (int c = 0; c < 50; ++c)
        for (int k = 1; k <= width; ++k) a(c, (c + k) % 50) = a((c + k) % 50, c) = -1.0;
      SolverBench solver(name, mbs::MatrixKind::positive_definite, test::pattern_of(a));
      solver.place(a);
      Eigen::VectorXd b = Eigen::VectorXd::Ones(50);
      allocations = 0;
      counting = true;
      const int bad = solver.factorize_placed();
      solver.solve_in_place(b.data());
      counting = false;
      EXPECT_EQ(bad, -1);
      EXPECT_EQ(allocations, 0) << name << " of width " << width;
    }
}

/// Steps and refreshes, after some that have settled.
std::int64_t allocations_in(mbs::Stepper& stepper, mbs::State s) {
  stepper.start(s);
  const auto steps = [&](int first, int last) {
    for (int k = first; k < last; ++k) stepper.step(s, 1e-3, s.time + 1e-3), stepper.refresh(s);
  };
  steps(0, 10);
  allocations = 0;
  counting = true;
  steps(10, 300);
  counting = false;
  return allocations;
}

/// But for null_space, which is a check of the others.
TEST(NoAllocation, InStepsOfAMechanism) {
  DrivenPendulum pendulum({});
  mbs::Mechanism linkage(mbs::read_mechanism("linkage", four_bar::text(3)));
  for (const auto& [formulation, integrator] : mbs::stepper_names()) {
    if (formulation == "null_space") continue;
    mbs::StepperSettings settings;
    settings.formulation = formulation;
    settings.integrator = integrator;
    EXPECT_EQ(allocations_in(*mbs::make_stepper(pendulum, settings), pendulum.at(0.0, 1.0, 0.5)), 0)
        << formulation << " " << integrator;
    EXPECT_EQ(allocations_in(*mbs::make_stepper(linkage, settings), linkage.described_state()), 0)
        << formulation << " " << integrator;
  }
}

/// Beside a wave that pushes it, with every kind of output; also where the highest frequency is looked at.
TEST(NoAllocation, InAMechanismAsASubsystem) {
  for (const double beta : {0.25, 1.0 / 12.0}) {
    mbs::SubsystemSettings settings{.step = 0.01, .stepper = {}};
    settings.stepper.index3.beta = beta;
    const auto pushed = mbs::make_subsystem(mbs::read_mechanism("pushed", pushed_pendulum), settings);
    FixedStep<Wave> wave(Wave(0.1, "N"));
    RunBench bench;
    bench.add("pushed", *pushed).add("wave", wave);
    bench.connect("wave.y", "pushed.F", "lagrange2").connect("wave.y", "pushed.G", "lagrange1");
    bench.connect("pushed.r", "wave.u", "lagrange0");
    EXPECT_EQ(allocations_in(bench, 300), 0) << "beta = " << beta;
  }
}

/// The same of a diagram, with events. Not by those with Newton's method: SUNDIALS allocates in each Jacobian
/// by differences.
TEST(NoAllocation, InADiagramAsASubsystem) {
  for (const char* integrator : {"rk4", "erkstep", "erkstep_fixed", "cvode_adams"}) {
    const auto mass =
        engine::make_subsystem(engine::read_diagram("pushed_mass", pushed_mass),
                               {.step = 0.01, .integrator = {.name = integrator}, .simulation = {}});
    FixedStep<Wave> wave(Wave(0.1, "N")), other(Wave(0.1, "N"));
    RunBench bench;
    bench.add("mass", *mass).add("wave", wave).add("other", other);
    bench.connect("wave.y", "mass.F", "lagrange2").connect("wave.y", "other.u", "lagrange1");
    bench.connect("other.y", "wave.u", "lagrange1");
    EXPECT_EQ(allocations_in(bench, 300), 0) << integrator;
  }
}

/// Its output is a force.
struct ForceRelay : Relay {
  using Relay::Relay;
  SubsystemInfo info() const {
    SubsystemInfo info = Relay::info();
    info.outputs[0].unit = "N";
    return info;
  }
};

/// It leads a relay that has events, saves its state before each step, and goes back.
TEST(NoAllocation, InAMechanismThatGoesBack) {
  const std::string pendulum = R"(
dimension = 2
gravity = [0, -9.81]
[points]
O = { at = [0, 0], fixed = true }
A = { at = [0, -1] }
[rods]
r = { points = ["O", "A"], mass = 1 }
[inputs]
F = { unit = "N" }
[forces]
f = { point = "A", direction = [1, 0], magnitude = "F" }
[outputs]
x = { position = "A.x" }
)";
  const auto mass = mbs::make_subsystem(mbs::read_mechanism("mass", pendulum), {.step = 0.01, .stepper = {}});
  FixedStep<ForceRelay> relay(ForceRelay({.width = 1e-3}, 0.01));
  RunBench bench;
  bench.add("mass", *mass).add("relay", relay).schedule("slowest-first");
  bench.coordination.order = {"mass", "relay"};
  bench.connect("relay.r", "mass.F", "").connect("mass.x", "relay.x", "lagrange3");
  EXPECT_EQ(allocations_in(bench, 3000), 0);
  Coordinator& run = bench.make(60.0);
  run.run();
  EXPECT_NE(run.notes().back().find("went back"), std::string::npos) << run.notes().back();
}

}  // namespace
}  // namespace tandem::test
#endif
