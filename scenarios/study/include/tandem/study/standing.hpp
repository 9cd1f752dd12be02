// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// What a standing study varies: all of schedule, reconstructions and steps, or what the scenario leaves out of these.
enum class Varied { all, left_out };

/// The scheme that rows are compared with, and its steps as parts of the scenario's.
struct Finest {
  std::string schedule = "fastest-first", reconstruction = "hermite";
  double steps = 1.0 / 16.0;
  bool is_judged = true;   ///< itself, by one with half its steps
  bool of_models = false;  ///< linear models run in its subsystems' places
};

/// What a standing study is made of.
struct Standing {
  Varied varied = Varied::all;
  Finest finest = {};
  /// Of coordination.order, tried with each scheme; the first is that of the reference. The scenario states one.
  std::vector<std::vector<std::string>> orders = {};
};

/// The study of a scenario that has none, as a text in the language of studies. It has every schedule with
/// one reconstruction for all connections, and own steps halved, as they are and doubled; at most 96 rows. Three more
/// have the reconstruction "impulse", where the scenario has [[links]] with which it can be coupled so; and three each
/// "impulse_stiffness" and "impulse_taylor".
/// Held outputs keep their reconstruction. Its table is `schemes`, its reference the finest. Rows are judged by the scenario's [judge], else by every connected output, 1 % of its peak.
/// Of steps none is varied where the scenario states one. Throws Error for a scenario that can't be opened, has no
/// connection, or leaves nothing out.
std::string standing_study(const scenario::Scenario& scenario, const Builtins& builtins,
                           const Standing& standing = {});

/// The connections, by their numbers, that the standing study gives any reconstruction: those of outputs that are not held,
/// without a lag. Throws Error for a scenario that can't be opened.
std::vector<std::size_t> free_connections(const scenario::Scenario& scenario, const Builtins& builtins,
                                          Varied varied = Varied::all);

/// What a connection is called in "connections[..]": its input, or where several are added in that its number.
std::string key_of(const scenario::Scenario& scenario, std::size_t connection);

/// Whether a scenario's file, or what was set, has a value at a path, "/coordination/order".
bool states(const scenario::Scenario& scenario, const std::string& path);

/// In words: which rows of its table `schemes` are within the tolerance, and which of these is cheapest
/// (fewest exchanges, then fewest own steps).
std::string standing_verdict(const std::filesystem::path& folder);

}  // namespace tandem::study
