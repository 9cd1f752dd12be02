// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "settings.hpp"

#include <algorithm>

#include "impulse.hpp"
#include "read_ladder.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/keys.hpp"

namespace tandem::scenario {
namespace {

std::vector<std::string> instances(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const SubsystemEntry& s : scenario.subsystems) names.push_back(s.name);
  return names;
}

void check_instance(const Place& place, const std::string& kind, const std::string& name,
                    const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) == known.end()) refuse(place, unknown(kind, name, known));
}

void note_places(const Section& section, std::initializer_list<const char*> keys, Scenario& to) {
  for (const char* key : keys) to.places[section.name(key)] = section.place(key);
}

/// Of a word that the language allows: they stand in the order of the kinds.
StartKind start_kind(const std::string& word) {
  const auto& words = scenario::keys().find("coordination.start")->words;
  return static_cast<StartKind>(std::find(words.begin(), words.end(), word) - words.begin());
}

/// Who is missing, or is sampled and has no place there, the coordinator tells.
void check_order(const Section& section, const Scenario& scenario) {
  const auto& order = scenario.coordination.order;
  const auto known = instances(scenario);
  for (const std::string& name : order)
    check_instance(section.place("order"), "coordination.order: subsystem", name, known);
  const bool twice = std::any_of(order.begin(), order.end(), [&](const std::string& name) {
    return std::count(order.begin(), order.end(), name) > 1;
  });
  if (twice || order.empty())
    section.wrong("order", "[" + listed(order) + "]",
                  "each subsystem that integrates itself once, slowest first, of " + listed(known));
}

void read_coupling(Section& section, Scenario& to) {
  const bool impulse = *section.text("coupling") != "signals";
  const auto period = section.positive("fast_period");
  const std::string carrier = *section.text("carrier");
  if (!impulse) return;
  to.carrier = carrier == "reactive"    ? Carrier::reactive
               : carrier == "surrogate" ? Carrier::surrogate
                                        : Carrier::automatic;
  to.fast_period = period.value_or(0.0);
  Coordination& c = to.coordination;
  if (to.chooses)
    section.wrong("scheme", "auto",
                  "stated, with coordination.coupling = \"" + *section.text("coupling") + "\"");
  if (section.node("schedule") && c.schedule != Schedule::Kind::fastest_first)
    section.wrong("schedule", std::string(Schedule::name(c.schedule)),
                  "fastest-first, with coordination.coupling = \"" + *section.text("coupling") + "\"");
  c.schedule = Schedule::Kind::fastest_first;
  if (!section.node("start")) c.start = StartKind::cold;  // the surrogate makes up for it
}

void read_coordination(Section& section, Scenario& to) {
  note_places(section, {"scheme", "schedule", "order", "communication_step", "start", "coupling", "carrier"},
              to);
  to.chooses = *section.text("scheme") == "auto";
  Coordination& c = to.coordination;
  c.schedule = Schedule::parse(*section.text("schedule"));
  c.order = section.texts("order");
  c.communication_step = section.positive("communication_step");
  c.start = start_kind(*section.text("start"));
  read_coupling(section, to);
  section.refuse_unknown();
  if (const std::string coupling = *section.text("coupling"); coupling != "signals")
    couple_by_impulse(coupling, to);
  if (section.node("order")) check_order(section, to);
}

double diverged_beyond(Section& section) {
  const toml::node* found = section.node("diverged_beyond");
  if (!found) return *section.number("diverged_beyond");
  const auto times =
      text::Values::refers(*found) ? section.number("diverged_beyond") : found->value<double>();
  if (!times || !(*times > 1.0))
    section.wrong("diverged_beyond", described(*found), "a number above 1, or inf");
  return *times;
}

void read_span(Section& section, Scenario& to) {
  note_places(section, {"start", "stop"}, to);
  to.start = *section.number("start");
  to.stop = section.required_number("stop");
  to.coordination.diverged_beyond = diverged_beyond(section);
  section.refuse_unknown();
  const toml::node* start = section.node("start");
  if (to.stop <= to.start)
    section.wrong("stop", described(*section.node("stop")),
                  "a time in s after span.start, which is " + (start ? described(*start) : "0"));
}

RowRules row_rules(Section& section, const Scenario& of) {
  RowRules rules;
  rules.every = section.positive("every").value_or(0.0);
  rules.from = section.number("from").value_or(rules.from);
  rules.to = section.number("to").value_or(rules.to);
  if (!(rules.from < rules.to))
    section.wrong("to", described(*section.node("to")), "a time in s after record.from");
  if (!(rules.from < of.stop)) section.wrong("from", described(*section.node("from")), "before span.stop");
  if (!(rules.to > of.start)) section.wrong("to", described(*section.node("to")), "after span.start");
  if (const double least = 1e-15 * (of.stop - of.start); rules.every > 0.0 && rules.every < least)
    section.wrong("every", described(*section.node("every")),
                  fmt::format("a number from {:.3g} s, of this span", least));
  return rules;
}

void read_record(Section& section, Scenario& to) {
  note_places(section, {"clock", "ports", "animate"}, to);
  to.animate = *section.flag("animate");
  const std::string level = *section.text("indicators");
  to.indicators = level == "off" ? Indication::off : level == "raw" ? Indication::raw : Indication::estimate;
  if (to.indicators == Indication::estimate) note_places(section, {"indicators"}, to);
  const std::string clock = section.text("clock").value_or("");
  to.recording.own = clock == "own";
  if (!to.recording.own) to.recording.clock = clock;
  to.recording.ports = section.texts("ports");
  if (section.node("ports") && to.recording.ports.empty())
    section.wrong("ports", "empty", "at least one port, or no such key: then all are recorded");
  to.recording.derivatives = *section.flag("derivatives");
  to.recording.format = *section.text("format") == "npy" ? RecordFormat::npy : RecordFormat::csv;
  to.recording.rows = row_rules(section, to);
  section.refuse_unknown();
  auto known = instances(to);
  known.emplace_back("own");
  if (!clock.empty()) check_instance(section.place("clock"), "record.clock: subsystem", clock, known);
}

void read_reference(Section& section, Scenario& to) {
  const std::filesystem::path file = section.required_text("file");
  to.reference = {to.file.parent_path() / file, section.required_number("tolerance"), section.place("file"),
                  read_measure(section, to)};
  section.refuse_unknown();
}

void read_judge(Section& section, Scenario& to) {
  to.judge = {section.required_text("quantity"), section.required_number("tolerance"),
              section.place("quantity"), read_measure(section, to)};
  section.refuse_unknown();
}

void read_view(Section& section, Scenario& to) {
  note_places(section, {"plots"}, to);
  to.plots = section.texts("plots");
  section.refuse_unknown();
}

}  // namespace

Measure read_measure(Section& section, const Scenario& of) {
  Measure measure;
  measure.norm = *section.text("norm") == "rms" ? Norm::rms : Norm::max;
  measure.from = section.number("from").value_or(measure.from);
  measure.to = section.number("to").value_or(measure.to);
  measure.shift = section.positive("shift").value_or(0.0);
  if (!(measure.from < measure.to))
    section.wrong("to", described(*section.node("to")), "a time in s after " + section.name("from"));
  if (!(of.start < of.stop)) return measure;  // there is no span, which is told
  if (!(measure.from < of.stop)) section.wrong("from", described(*section.node("from")), "before span.stop");
  if (!(measure.to > of.start)) section.wrong("to", described(*section.node("to")), "after span.start");
  if (!(measure.shift < of.stop - of.start))
    section.wrong("shift", described(*section.node("shift")), "a number below the span's length");
  return measure;
}

const std::vector<std::pair<std::string, std::function<void(Section&, Scenario&)>>>& settings() {
  static const std::vector<std::pair<std::string, std::function<void(Section&, Scenario&)>>> all{
      {"coordination", read_coordination},
      {"span", read_span},
      {"record", read_record},
      {"reference", read_reference},
      {"judge", read_judge},
      {"view", read_view},
      {"ladder", read_ladder}};
  return all;
}

}  // namespace tandem::scenario
