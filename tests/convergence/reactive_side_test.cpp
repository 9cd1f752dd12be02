// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A fast side that integrates a surrogate along, call by call.
#include "tandem/coordinator/impulse/reactive_side.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tandem/fixed_step.hpp"
#include "two_mass/masses.hpp"
#include "two_mass/model.hpp"

namespace tandem::test {
namespace {

/// A fast side with its surrogate, and what it reads of the slow one over that one's first step.
struct Reacting {
  explicit Reacting(double ratio) {
    two_mass::Settings settings;
    settings.frequency_ratio = ratio;
    const two_mass::Model model(settings);
    const two_mass::Motion start = model.exact(0.0);
    const double free = -model.k3 * start.x2 / model.m2;
    ImpulseCoupling coupling;
    coupling.links = {{"N", "m", start.v2, free}}, coupling.accelerance = {1.0 / model.m2};
    coupling.own_step = 0.01, coupling.slow_step = ratio / 100.0, coupling.fast_period = 1.0;
    side = reactive_side(
        std::make_unique<FixedStep<two_mass::FastMass>>(two_mass::FastMass(model, {.force = true})), coupling,
        {{.effort = {2}, .displacement = {0}}}, "surrogate");
    place = {1e9, 0.0, {start.x2, start.v2, free / 2.0}};
    clock = side->initialize(0.0, 100.0, std::array{0.0, start.x2}, rows);
  }
  /// Up to t, in calls with room for so many rows.
  void go_to(double t, std::int64_t room) {
    const Signal u[] = {Signal(&nothing, 1, 0), Signal(&place, 1, 2)};
    while (clock.next_time < t + 1e-9) {
      Samples y(memory.data() + rows.size() * stride, stride, room);
      clock = side->advance(t, false, u, y);
      rows.set_size(rows.size() + y.size());
    }
  }
  std::vector<double> told() const {
    return {memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(rows.size() * stride)};
  }

  static constexpr std::int64_t stride = 2 + 6 * 3;
  std::unique_ptr<Subsystem> side;
  Segment nothing{1e9, 0.0, {0.0}}, place{};
  std::vector<double> memory = std::vector<double>(stride * 2000);
  Samples rows{memory.data(), stride, 1000};
  Clock clock{};
};

/// A slow step of 3 s, and steps that fit nothing.
TEST(ReactiveSide, HasTheSameBitsInCallsOfAnyLength) {
  for (const double ratio : {300.0, 123.4}) {
    Reacting whole(ratio), parts(ratio);
    whole.go_to(ratio / 100.0, 900);
    for (double t = 0.013; t < ratio / 100.0; t += 0.047) parts.go_to(t, 2);
    parts.go_to(ratio / 100.0, 1);
    EXPECT_EQ(whole.told(), parts.told());
  }
}

/// From a state that is saved, and from one that has left the process as bytes.
TEST(ReactiveSide, GoesOnFromASavedStateWithTheSameBits) {
  Reacting one(300.0), other(300.0);
  ASSERT_EQ(one.side->info().row_size(), Reacting::stride);
  one.go_to(1.0, 900);
  const StateId id = one.side->save_state();
  const auto bytes = one.side->serialize_state(id);
  const Samples before = one.rows;
  one.go_to(3.0, 900);
  const auto expected = one.told();
  one.rows = before, one.clock = one.side->restore_state(id);
  one.go_to(3.0, 900);
  EXPECT_EQ(one.told(), expected);
  other.go_to(1.0, 900);
  other.clock = other.side->restore_state(other.side->deserialize_state(bytes));
  other.go_to(3.0, 900);
  EXPECT_EQ(other.told(), expected);
}

}  // namespace
}  // namespace tandem::test
