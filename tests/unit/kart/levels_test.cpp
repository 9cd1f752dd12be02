// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Why the modes of level iii are not those of level ii: what it has more is taken away until they agree.
#include <gtest/gtest.h>

#include "kart_run.hpp"
#include "tandem/mbs/mechanism/modes.hpp"

namespace tandem::test {
namespace {

using Replaced = std::vector<std::pair<std::string, std::string>>;

struct Swings {
  mbs::Mode heave, pitch;
};

/// By what they are called in the plane or in space.
Swings swings(const std::string& text) {
  mbs::Mechanism m(kart(text));
  Swings found;
  for (const mbs::Mode& mode : mbs::modes(m, mbs::initial_state(m, 0.0))) {
    const std::string name = mode.oscillates() ? mbs::name_of(m, mode) : "";
    if (name == "heave" || name == "chassis along y") found.heave = mode;
    if (name == "pitch" || name == "chassis about z") found.pitch = mode;
  }
  return found;
}

const Replaced no_rolling_in_the_plane = {{"rolling = 0.02", "rolling = 0"}};
const Replaced no_rolling = {{"rolling = { value = 0.02", "rolling = { value = 0"}};

/// Wheel rates and dampers of level ii; springs carry the sprung mass alone at their length at rest.
const Replaced springs_of_level_ii = {{"spring_front = { value = 13500", "spring_front = { value = 13796"},
                                      {"damper_front = { value = 410", "damper_front = { value = 379.5"},
                                      {"free_front = { value = 0.34990", "free_front = { value = 0.348112"},
                                      {"spring_rear = { value = 16600", "spring_rear = { value = 17049"},
                                      {"damper_rear = { value = 500", "damper_rear = { value = 462"},
                                      {"free_rear = { value = 0.38519", "free_rear = { value = 0.382755"}};

/// Arms weigh nothing, the uprights have their mass at the wheel centres.
const Replaced mass_at_wheels = {{"mass = 0.3 }", "mass = 1e-6 }"},
                                 {"mass = 0.4 }", "mass = 1e-6 }"},
                                 {"mass = 0.5 }", "mass = 1e-6 }"},
                                 {"mass = 3\n", "mass = 4.4\n"},
                                 {"mass = 5.2\n", "mass = 7\n"}};

/// Of uprights and, about their diameters, of wheels.
const Replaced no_turning_inertia = {
    {"[[0.012, 0, 0], [0, 0.012, 0], [0, 0, 0.012]]", "[[1e-6, 0, 0], [0, 1e-6, 0], [0, 0, 1e-6]]"},
    {"diametral_inertia = 0.025", "diametral_inertia = 1e-6"},
    {"diametral_inertia = 0.06", "diametral_inertia = 1e-6"}};

Swings of_level_iii(const std::vector<Replaced>& without) {
  Replaced all;
  for (const Replaced& part : without) all.insert(all.end(), part.begin(), part.end());
  return swings(kart_text("spatial_scalar_spin", all));
}

/// What is left is the arcs on which the arms lead the wheels: 0.1 % of the frequencies.
TEST(KartLevels, LevelIIIWithoutWhatItHasMoreSwingsAsLevelII) {
  const Swings plane = swings(kart_text("plane", no_rolling_in_the_plane));
  const Swings space =
      of_level_iii({without_lateral, no_rolling, springs_of_level_ii, mass_at_wheels, no_turning_inertia});
  for (const auto& [ii, iii] : {std::pair(plane.heave, space.heave), {plane.pitch, space.pitch}}) {
    EXPECT_NEAR(iii.frequency() / ii.frequency(), 1.0, 0.0015);
    EXPECT_NEAR(iii.damping() / ii.damping(), 1.0, 0.0015);
  }
}

/// The card's table: each step on the way to level iii, in its order, as it was computed there.
TEST(KartLevels, EachStepFromLevelIIToLevelIIIIsThatOfTheCard) {
  const struct {
    Swings swings;
    double heave[2], pitch[2];
  } steps[] = {{swings(kart_text("plane")), {1.680, 0.1233}, {2.856, 0.2288}},
               {of_level_iii({without_lateral, no_rolling, springs_of_level_ii, mass_at_wheels}),
                {1.680, 0.1231},
                {2.851, 0.2208}},
               {of_level_iii({without_lateral, no_rolling}), {1.654, 0.1341}, {2.781, 0.2375}},
               {of_level_iii({without_lateral}), {1.654, 0.1344}, {2.779, 0.2454}},
               {of_level_iii({}), {1.658, 0.1341}, {2.787, 0.2448}}};
  for (const auto& step : steps) {
    EXPECT_NEAR(step.swings.heave.frequency(), step.heave[0], 6e-4);  // the digits that are printed
    EXPECT_NEAR(step.swings.heave.damping(), step.heave[1], 6e-5);
    EXPECT_NEAR(step.swings.pitch.frequency(), step.pitch[0], 6e-4);
    EXPECT_NEAR(step.swings.pitch.damping(), step.pitch[1], 6e-5);
  }
}

}  // namespace
}  // namespace tandem::test
