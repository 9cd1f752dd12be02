// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tandem/coordinator/power_link.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/scenario/comparison.hpp"
#include "tandem/scenario/impulse_entry.hpp"
#include "tandem/scenario/ladder_entry.hpp"
#include "tandem/text/place.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem::scenario {

using text::located;
using text::Place;
using text::refuse;

struct Parameter {
  std::string name;
  Parameters::Value value;
  Place place;
  bool refers = false;   ///< it is made of constants
  std::string key = {};  ///< that sets it, if it stands in the table of its subsystem
};

/// What an input is, "port" or "port[i]".
struct InputEntry {
  std::string port;
  std::variant<double, std::shared_ptr<const TimeSeries>> value;
  Place place;

  /// At t [s].
  double at(double t) const;
};

struct SubsystemEntry {
  std::string name, source;           ///< source: of a command "spawn:"
  std::vector<Parameter> parameters;  ///< those that all subsystems share are among them
  std::vector<InputEntry> inputs;
  Place place, source_place;
  std::vector<std::string> command = {};    ///< a program and its arguments; empty: there is a source
  bool isolated = false;                    ///< in a process of its own
  std::vector<std::string> overrides = {};  ///< of the file that is the source, "KEY=VALUE"
  /// Outputs that it is to have besides, "x.by.F,...": what an input accelerates, if its source can tell (mechanisms).
  std::string accelerances = {};
  std::string reactions = {};  ///< displacements, "x,...", for ports of its coordinates likewise
  /// Of a surrogate that coordination.coupling put in: what its parameters are asked of. Else null.
  std::shared_ptr<const ImpulseEntry> impulse = {};

  /// "lib:./x.so", without parameters, or "command [...]".
  std::string address() const;
  /// "lib" of that, and the file that stands behind it.
  std::string scheme() const;
  std::filesystem::path file() const;

  /// The place that an error of opening it is about: of the parameter that the sentence names first, else the
  /// source.
  Place place_named_in(const std::string& sentence) const;
};

struct ConnectionEntry {
  Connection connection;
  Place place, from_place, to_place, how_place;

  /// The place that an error about this connection is about: of an end that is not known, or of the
  /// reconstruction, or of what the command line has set; else of the connection.
  Place place_named_in(const std::string& sentence) const;
};

/// Two connections that carry a power.
struct LinkEntry {
  StatedLink link;
  Place place;
  Effective effective = {};
};

/// Results to compare with.
struct ReferenceEntry {
  std::filesystem::path file;  ///< of the scenario's folder if it was not absolute
  double tolerance;            ///< as a fraction of each column's largest magnitude, or of its rms
  Place place;
  Measure measure = {};
};

/// What the scene is judged by.
struct JudgeEntry {
  std::string quantity;  ///< an output
  double tolerance;      ///< as a fraction of its largest magnitude, or of its rms
  Place place;
  Measure measure = {};
};

/// What a run tells of how far its coupling is off: what it does anyway, or also an estimate of the judged output's error.
enum class Indication { off, raw, estimate };

/// A scenario file as it was read: texts and numbers with their places, units and ports not yet looked at.
struct Scenario {
  std::filesystem::path file;
  std::string name, description;
  std::vector<std::pair<std::string, double>> constants;  ///< used ones that are numbers, not made of others
  std::vector<SubsystemEntry> subsystems;
  std::vector<ConnectionEntry> connections;
  std::vector<LinkEntry> links;  ///< besides those that are found by their units
  Coordination coordination;
  double fast_period = 0.0;              ///< [s]: the shortest of the coupled system; 0: not known
  Carrier carrier = Carrier::automatic;  ///< of impulse couplings
  bool chooses = false;  ///< coordination.scheme is auto: what is left out has to be taken before it runs
  std::optional<Reconstruction> otherwise;  ///< of connections that have none and are not of held outputs
  double start = 0.0, stop = 0.0;           ///< [s]
  Recording recording;                      ///< without its directory
  Indication indicators = Indication::raw;
  std::optional<ReferenceEntry> reference;
  std::optional<JudgeEntry> judge;
  std::optional<LadderEntry> ladder;
  bool animate = false;            ///< where points are is recorded, of sources that can tell
  std::vector<std::string> plots;  ///< outputs that `tandem view` plots at first

  std::vector<std::string> overrides;  ///< "KEY=VALUE"
  std::vector<std::string> taken;      ///< likewise, by coordination.scheme = "auto" or as a fast period
  std::vector<std::string> remarks;    ///< of a system of SSP what its user should know
  std::string values;                  ///< the file with the overrides in it, as JSON
  /// Of single keys by their path, "coordination.order"; absent: the file.
  std::map<std::string, Place> places;

  Place place(const std::string& key) const;
  /// The place of what an error's sentence names: a connection, a key or a subsystem, else the file.
  Place place_named_in(const std::string& sentence) const;
};

/// Whether coordination.coupling has put surrogates in.
bool by_impulse(const Scenario& scenario);
/// Whether it has, and the fast period has to be found before it runs (stability/fast_period.hpp).
bool lacks_fast_period(const Scenario& scenario);

/// "mechanism" of a file with a dimension, points, bodies, ..., "diagram" of one with blocks, "" else: of a
/// scenario.
std::string kind_alone(const std::filesystem::path& file);

/// Reads a scenario with the overrides of the command line. Throws Error with file, line, the value found and
/// what is allowed.
Scenario read(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

}  // namespace tandem::scenario
