// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models in C by tandem/fixed_step.h and tandem/sampled.h, beside the same ones in C++ by the headers of
// that.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "c_models.h"
#include "refusal.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/sampled.hpp"

namespace tandem {
namespace {

using test::refuses;

/// c_integral in C++.
class IntegralTwin {
 public:
  SubsystemInfo info() const { return {"integral", {{"u", "m/s"}}, {{"x", "m"}, {"steps", "1"}}, {}, {}}; }
  double own_step() const { return 0.1; }
  void start(double, std::span<const double>) { x_ = steps_ = 0.0; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    const double first = u[0].value(s.begin), middle = u[0].value(s.begin + s.length / 2.0),
                 last = u[0].value(s.end);
    x_ += 2.0 * s.length * ((first + 4.0 * middle + last) / 6.0);
    steps_ += 1.0;
  }
  void outputs(double* y) const { y[0] = x_, y[1] = steps_; }

 private:
  double x_ = 0.0, steps_ = 0.0;
};

/// c_switch in C++.
class SwitchTwin {
 public:
  SubsystemInfo info() const {
    SubsystemInfo info{"switch", {{"x", "m"}}, {{"r", "m/s"}, {"c", "m"}}, {}, {.events = true}};
    info.outputs[0].held = true;
    return info;
  }
  double own_step() const { return 0.07; }
  void start(double, std::span<const double>) { r_ = before_ = 1.0, c_ = 0.0; }
  bool step_to_event(OwnStep& s, std::span<const Signal> x) {
    double low = s.begin, high = s.end, middle;
    const bool event = beyond(x[0].value(high));
    while (event && (middle = low + (high - low) / 2.0) > low && middle < high)
      (beyond(x[0].value(middle)) ? high : low) = middle;
    s.end = high;
    c_ += r_ * (s.end - s.begin);
    before_ = r_;
    if (event) r_ = -r_;
    return event;
  }
  void outputs(double* y) const { y[0] = r_, y[1] = c_ + r_; }
  void outputs_before(double* y) const { y[0] = before_, y[1] = c_ + before_; }

 private:
  bool beyond(double x) const { return r_ > 0.0 ? x > 0.1 : x < -0.1; }
  double r_ = 1.0, before_ = 1.0, c_ = 0.0;
};

/// c_follower in C++.
class FollowerTwin {
 public:
  SubsystemInfo info() const { return {"follower", {{"u", "m"}}, {{"y", "m"}}, {{0, 0}}, {}}; }
  double own_step() const { return 0.07; }
  void start(double, std::span<const double> u0) { x_ = 0.0, u_ = u0[0]; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    x_ += s.length * u[0].value(s.begin + s.length / 2.0);
    u_ = u[0].value(s.end);
  }
  bool jump(double t, std::span<const Signal> u) {
    const double before = std::exchange(u_, u[0].value(t));
    return u_ != before;
  }
  void outputs(double* y) const { *y = x_ + u_; }

 private:
  double x_ = 0.0, u_ = 0.0;
};

/// c_sum in C++.
class SumTwin {
 public:
  SubsystemInfo info() const { return {"sum", {{"x", "m"}}, {{"x", "m"}}, {{0, 0}}, {}}; }
  double own_step() const { return 0.25; }
  double offset() const { return 0.1; }
  double latency() const { return 0.02; }
  void start(double, std::span<const double>) { sum_ = 0.0; }
  void step(const OwnStep& s, std::span<const Signal> u) { sum_ += u[0].value(s.begin); }
  void outputs(double* y) const { *y = sum_; }
  void outputs(double* y, std::span<const double> u) const { *y = sum_ + 0.5 * u[0]; }

 private:
  double sum_ = 0.0;
};

/// Cubics from t = -1 to 7, of which some jump where they begin: at times that are no nodes, and at nodes.
struct Pieces {
  explicit Pieces(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    double t = -1.0;
    for (int k = 0; k < 60; ++k) {
      const double begin = t;
      t = k % 5 == 0 ? -0.7 + 0.1 * (k + 7) : t + 0.1 * (1.0 + any(random));
      segments.push_back({t, begin, {0.1 + 0.3 * any(random), any(random), any(random), any(random)}});
      mark_jump(segments.back(), k > 0 && k % 3 != 0);
    }
    segments.back().end = 1e9;
    signal = Signal(segments.data(), static_cast<std::int32_t>(segments.size()), 3);
  }
  std::vector<Segment> segments;
  Signal signal;
};

/// Rows and clocks of calls to random limits, with and without landing, with room for one row or for many.
std::vector<double> driven(Subsystem& s, std::uint32_t seed) {
  std::mt19937 random(seed);
  const Pieces input(random);
  const std::int64_t stride = s.info().row_size();
  std::vector<double> told, memory(static_cast<std::size_t>(100 * stride)), u0{0.3};
  const auto tell = [&](const Clock& clock, const Samples& y) {
    told.insert(told.end(), memory.data(), memory.data() + y.size() * stride);
    told.insert(told.end(), {clock.time, clock.next_time, static_cast<double>(clock.stop)});
  };
  Samples first(memory.data(), stride, 1);
  Clock clock = s.initialize(-0.7, 6.0, u0, first);
  tell(clock, first);
  for (double limit = -0.7; limit < 5.5;) {
    if (random() % 3 != 0) limit += 0.25 * static_cast<double>(random() % 1000) / 1000.0;
    Samples y(memory.data(), stride, random() % 2 ? 100 : 2);
    clock = s.advance(limit, random() % 2 == 0, {&input.signal, 1}, y);
    tell(clock, y);
  }
  return told;
}

template <class Model>
void is_the_same_in_c(const tandem_subsystem_api* api) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    CSubsystem in_c(api, "");
    FixedStep<Model> in_cpp{Model()};
    const auto expected = driven(in_cpp, seed), found = driven(in_c, seed);
    ASSERT_EQ(found.size(), expected.size()) << seed;
    ASSERT_EQ(std::memcmp(found.data(), expected.data(), expected.size() * sizeof(double)), 0) << seed;
  }
}

TEST(CModel, TakesTheStepsThatFixedStepTakesInCpp) { is_the_same_in_c<IntegralTwin>(c_integral()); }

TEST(CModel, GivesTheRowsOfEventsThatFixedStepGivesInCpp) { is_the_same_in_c<SwitchTwin>(c_switch()); }

TEST(CModel, GivesTheRowsOfInputsThatJumpAsFixedStepDoesInCpp) {
  is_the_same_in_c<FollowerTwin>(c_follower());
  std::ptrdiff_t marked = 0;
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    FixedStep<FollowerTwin> in_cpp{FollowerTwin()};
    const auto rows = driven(in_cpp, seed);
    marked += std::count(rows.begin(), rows.end(), 1.0);
  }
  EXPECT_GT(marked, 100);
}

TEST(CModel, SamplesAsSampledDoesInCpp) {
  CSubsystem in_c(c_sum(), "");
  Sampled<SumTwin> in_cpp{SumTwin()};
  EXPECT_EQ(in_c.info().sampling.period, 0.25);
  EXPECT_EQ(in_c.info().sampling.latency, 0.02);
  std::vector<double> told[2];
  for (Subsystem* s : {static_cast<Subsystem*>(&in_c), static_cast<Subsystem*>(&in_cpp)}) {
    double row[3], u = 0.7, y = 0.0;
    Samples rows(row, 3, 1);
    Clock clock = s->initialize(-0.7, 9.0, {&u, 1}, rows);
    auto& numbers = told[s == &in_c ? 0 : 1];
    numbers.insert(numbers.end(), {row[0], row[1], row[2], clock.time, clock.next_time});
    for (int k = 0; k < 20; ++k) {
      const double t = clock.next_time;
      u = 0.1 * k * k - 1.0;
      s->sample(t, SamplePart::outputs, {&u, 1}, {&y, 1});
      clock = s->sample(t, k % 2 ? SamplePart::both : SamplePart::states, {&u, 1}, {&y, 1});
      numbers.insert(numbers.end(), {y, clock.time, clock.next_time});
    }
  }
  EXPECT_EQ(told[0], told[1]);
}

TEST(CModel, SaysWhatItTakesAndWhatItIs) {
  const CSubsystem s(c_integral(), "gain=3");
  ASSERT_EQ(s.info().parameters.size(), 4U);
  EXPECT_EQ(s.info().parameters[0].otherwise, "2");
  EXPECT_EQ(s.info().parameters[2].unit, std::nullopt);
  EXPECT_EQ(s.info().outputs[0].nominal, 3.0);
  EXPECT_TRUE(s.info().abilities.lands && s.info().abilities.restarts && s.info().abilities.serializes_state);
  EXPECT_TRUE(CSubsystem(c_switch(), "").info().outputs[0].held);
}

/// x(1) of u = t.
double integral_of(const std::string& parameters) {
  CSubsystem s(c_integral(), parameters);
  const Segment line{9.0, 0.0, {0.0, 1.0}};
  const Signal u(&line, 1, 1);
  double rows[4 * 100], u0 = 0.0;
  Samples y(rows, 4, 100);
  s.initialize(0.0, 1.0, {&u0, 1}, y);
  s.advance(1.0, true, {&u, 1}, y);
  return y.values(y.size() - 1)[0];
}

TEST(CModel, NumbersAndWordsAreGivenOrStandAsTheyAreDeclared) {
  EXPECT_NEAR(integral_of(""), 1.0, 1e-14);  // Simpson's rule is exact, and gain is 2
  EXPECT_NEAR(integral_of("gain=0.5"), 0.25, 1e-14);
  EXPECT_NEAR(integral_of("rule=euler&gain=1"), 0.45, 1e-14);  // 0.1 (0 + 0.1 + ... + 0.9)
  EXPECT_NEAR(integral_of("h=0.5&gain=1&rule=euler"), 0.25, 1e-14);
}

TEST(CModel, WhatItChecksItRefusesInItsOwnWords) {
  const auto making = [](const char* parameters) { return [=] { CSubsystem(c_integral(), parameters); }; };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"create: rule is 'trapez'; allowed are simpson and euler"}, making("rule=trapez")));
  CSubsystem s(c_integral(), "h=-1");
  double row[4], u0 = 0.0;
  Samples y(row, 4, 1);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"the own step is -1 s; allowed is one above 0"}, [&] {
    s.initialize(0.0, 1.0, {&u0, 1}, y);
  }));
}

/// By its table alone, without tandem's own look at them.
TEST(CModel, RefusesParametersItselfToo) {
  const auto sentence = [](const char* parameters) {
    void* self = nullptr;
    EXPECT_EQ(c_integral()->create(parameters, &self), TANDEM_INVALID_ARGUMENT);
    const std::string said = c_integral()->last_error(self);
    c_integral()->destroy(self);
    return said;
  };
  EXPECT_EQ(sentence("gian=1"), "'gian=1' is no parameter");
  EXPECT_EQ(sentence("gain=1&gain=2"), "'gain=2' is there twice, or without value");
  EXPECT_EQ(sentence("gain"), "'gain' is there twice, or without value");
  EXPECT_EQ(sentence("h=0.1&gain="), "parameter 'gain' is no finite number");
  for (const char* none : {"h=a", "h=0.1s", "h=nan", "h=inf"})
    EXPECT_EQ(sentence(none), "parameter 'h' is no finite number");
}

TEST(CModel, AnErrorOfAStepKeepsTheRowsBeforeIt) {
  CSubsystem s(c_integral(), "fails_at=0.35");
  const Segment zero{9.0, 0.0, {0.0}};
  const Signal u(&zero, 1, 0);
  double rows[4 * 100], u0 = 0.0;
  Samples y(rows, 4, 100);
  s.initialize(0.0, 1.0, {&u0, 1}, y);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"subsystem 'integral', advance: no step to t = 0.4 s"}, [&] {
    s.advance(1.0, true, {&u, 1}, y);
  }));
  EXPECT_EQ(y.size(), 4);
}

}  // namespace
}  // namespace tandem
