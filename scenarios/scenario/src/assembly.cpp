// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/assembly.hpp"

#include <algorithm>
#include <unordered_set>

namespace tandem::scenario {
namespace {

void add_once(std::vector<std::string>& notes, const std::string& note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

}  // namespace

Assembly::Assembly(const Scenario& scenario, const Builtins& builtins, bool profile, int threads)
    : scenario_(scenario), parts_(scenario, builtins, Code::run) {
  std::vector<Subsystem*> subsystems;
  for (int i = 0; i < topology().size(); ++i) subsystems.push_back(&subsystem(i));
  Coordination coordination = parts_.coordination();
  coordination.profile = profile;
  coordination.threads = threads;
  coordinator_ = located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
                         [&] {
                           return std::make_unique<Coordinator>(topology(), subsystems, coordination,
                                                                TimeSpan{scenario.start, scenario.stop});
                         });
}

/// "INSTANCE.POINT.x": outputs of a mechanism with one more dot than its own have.
void Assembly::add_positions(std::vector<std::string>& ports) const {
  const std::unordered_set<std::string> there(ports.begin(), ports.end());
  for (const std::string& name : topology().output_names()) {
    const bool position = name.size() > 2 && name[name.size() - 2] == '.' && name.back() >= 'x' &&
                          name.back() <= 'z' && std::count(name.begin(), name.end(), '.') > 1;
    if (position && !there.contains(name)) ports.push_back(name);
  }
}

std::unique_ptr<Recorder> Assembly::recorder(const std::filesystem::path& directory,
                                             std::function<void()> begin) const {
  Recording recording = scenario_.recording;
  recording.begin = std::move(begin);
  recording.directory = directory;
  if (scenario_.animate && !recording.ports.empty()) add_positions(recording.ports);
  return located(scenario_.place("record.ports"),
                 [&] { return std::make_unique<Recorder>(*coordinator_, recording); });
}

/// What a surrogate of an impulse coupling exchanges with its slow side is off by intent: a mean force, and a motion without
/// its ripple.
std::vector<int> Assembly::off_by_intent() const {
  std::vector<int> all;
  if (!by_impulse(scenario_)) return all;
  for (std::size_t k = 0; k < topology().lines().size(); ++k) {
    const Line& line = topology().lines()[k];
    const std::string from = topology().output_name(line.source, line.output),
                      to = topology().input_name(line.reader, line.input);
    for (const SubsystemEntry& entry : scenario_.subsystems) {
      if (!entry.impulse) continue;
      const auto is = [&](const std::string& surrogate, const std::string& slow) {
        return surrogate.starts_with(entry.name + ".") && slow.starts_with(entry.impulse->slow + ".");
      };
      if (is(from, to) || is(to, from)) all.push_back(static_cast<int>(k));
    }
  }
  return all;
}

/// The links that it states, and those that are found of other lines.
std::unique_ptr<Indicators> Assembly::indicators() const {
  const auto left_out = off_by_intent();
  std::vector<PowerLink> links;
  for (const LinkEntry& entry : scenario_.links)
    if (!parts_.reactive())  // else they are inside of the fast sides
      located(entry.place, [&] { links.push_back(power_link(topology(), entry.link)); });
  const auto taken = [&](int line) {
    return std::count(left_out.begin(), left_out.end(), line) > 0 ||
           std::any_of(links.begin(), links.end(),
                       [line](const PowerLink& one) { return one.effort == line || one.back == line; });
  };
  for (const PowerLink& link : power_links(topology()))
    if (!taken(link.effort) && !taken(link.back)) links.push_back(link);
  if (scenario_.indicators == Indication::off) return nullptr;
  return std::make_unique<Indicators>(*coordinator_, links, left_out);
}

void Assembly::initialize() {
  located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
          [&] { coordinator_->initialize(); });
  of_parts_ = parts_.notes();
}

std::vector<std::string> Assembly::notes() const {
  std::vector<std::string> all = coordinator_->notes();
  all.insert(all.end(), of_parts_.begin(), of_parts_.end());
  for (const SubsystemEntry& entry : scenario_.subsystems) {
    if (!entry.impulse) continue;
    const int who = *topology().instance(entry.name);  // which knows more as the run goes on
    for (const std::string& remark : subsystem(who).remarks(scenario_.stop))
      add_once(all, parts_.note_of(who, remark));
  }
  return all;
}

std::string with_address(const Scenario& scenario, const Builtins& builtins, std::string sentence) {
  for (const SubsystemEntry& entry : scenario.subsystems) {
    const std::string address = entry.address();
    if (source_of(entry.source, builtins).elsewhere &&
        sentence.find("'" + entry.name + "'") != std::string::npos &&
        sentence.find(address) == std::string::npos)
      sentence += " (" + entry.name + " is at " + address + ")";
  }
  return sentence;
}

}  // namespace tandem::scenario
