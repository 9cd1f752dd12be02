// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/assembly.hpp"

#include <algorithm>

#include "tandem/error.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/nearest.hpp"

namespace tandem::scenario {
namespace {

bool is_elsewhere(const SubsystemEntry& entry, const Builtins& builtins) {
  return builtins.addresses.count(entry.source.substr(0, entry.source.find(':'))) != 0;
}

/// An error of opening a subsystem that lives elsewhere names it: the address alone may serve several.
template <class Open>
auto far_named(const SubsystemEntry& entry, const Builtins& builtins, const Open& opening) {
  try {
    return opening();
  } catch (const Error& error) {
    if (!is_elsewhere(entry, builtins)) throw;
    throw Error(error.code(), "subsystem '" + entry.name + "': " + error.what());
  }
}

}  // namespace

Assembly::Assembly(const Scenario& scenario, const Builtins& builtins, bool profile) : scenario_(scenario) {
  std::vector<Subsystem*> subsystems;
  for (const SubsystemEntry& entry : scenario.subsystems) {
    subsystems_.push_back(opened(entry, builtins));
    subsystems.push_back(subsystems_.back().get());
    located(entry.place, [&] { topology_.add(entry.name, subsystems_.back()->info()); });
  }
  for (const SubsystemEntry& entry : scenario.subsystems)
    for (const StartValue& start : entry.inputs)
      located(start.place, [&] { topology_.set_start(entry.name + "." + start.port, start.value); });
  for (const ConnectionEntry& entry : scenario.connections)
    located([&](const std::string& sentence) { return entry.place_named_in(sentence); },
            [&] { topology_.connect(entry.connection); });
  if (scenario.judge) check_judge();
  check_plots();
  const auto place_of = [&](const std::string& sentence) { return scenario_.place_named_in(sentence); };
  located(place_of, [&] { topology_.check(); });
  Coordination coordination = scenario.coordination;
  coordination.profile = profile;
  coordinator_ = located(place_of, [&] {
    return std::make_unique<Coordinator>(topology_, subsystems, coordination,
                                         TimeSpan{scenario.start, scenario.stop});
  });
}

std::unique_ptr<Subsystem> Assembly::opened(const SubsystemEntry& entry, const Builtins& builtins) {
  Opening opening{{}, std::filesystem::path(entry.place.file).parent_path()};
  for (const Parameter& p : entry.parameters) opening.parameters.set(p.name, p.value);
  return located([&](const std::string& sentence) { return entry.place_named_in(sentence); },
                 [&] {
                   return far_named(entry, builtins,
                                    [&] { return open(entry.source, builtins, std::move(opening)); });
                 });
}

std::vector<std::string> Assembly::outputs() const {
  std::vector<std::string> names;
  for (int i = 0; i < topology_.size(); ++i)
    for (int k = 0; k < topology_.info(i).output_size(); ++k) names.push_back(topology_.output_name(i, k));
  return names;
}

void Assembly::check_judge() const {
  const auto known = outputs();
  const JudgeEntry& judge = *scenario_.judge;
  if (std::find(known.begin(), known.end(), judge.quantity) == known.end())
    refuse(judge.place, unknown("judge.quantity: output", judge.quantity, known));
}

void Assembly::check_plots() const {
  const auto known = outputs();
  for (const std::string& name : scenario_.plots)
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(scenario_.place("view.plots"), unknown("view.plots: output", name, known));
}

/// "INSTANCE.POINT.x": outputs of a mechanism with one more dot than its own have.
void Assembly::add_positions(std::vector<std::string>& ports) const {
  for (const std::string& name : outputs()) {
    const bool position = name.size() > 2 && name[name.size() - 2] == '.' && name.back() >= 'x' &&
                          name.back() <= 'z' && std::count(name.begin(), name.end(), '.') > 1;
    if (position && std::find(ports.begin(), ports.end(), name) == ports.end()) ports.push_back(name);
  }
}

std::unique_ptr<Recorder> Assembly::recorder(const std::filesystem::path& directory) const {
  Recording recording = scenario_.recording;
  recording.directory = directory;
  if (scenario_.animate && !recording.ports.empty()) add_positions(recording.ports);
  return located(scenario_.place("record.ports"),
                 [&] { return std::make_unique<Recorder>(*coordinator_, recording); });
}

void Assembly::initialize() {
  located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
          [&] { coordinator_->initialize(); });
  redundant_.clear();
  for (int i = 0; i < topology_.size(); ++i)
    if (const auto names = mbs::redundant_equations(subsystem(i)); !names.empty())
      redundant_.push_back("mechanism '" + topology_.name(i) + "' has " + std::to_string(names.size()) +
                           " redundant equation" + (names.size() > 1 ? "s" : "") + ": " + listed(names));
}

std::vector<std::string> Assembly::notes() const {
  std::vector<std::string> all = coordinator_->notes();
  all.insert(all.end(), redundant_.begin(), redundant_.end());
  return all;
}

std::string with_address(const Scenario& scenario, const Builtins& builtins, std::string sentence) {
  for (const SubsystemEntry& entry : scenario.subsystems) {
    const std::string address = entry.source.substr(0, entry.source.find('?'));
    if (is_elsewhere(entry, builtins) && sentence.find("'" + entry.name + "'") != std::string::npos &&
        sentence.find(address) == std::string::npos)
      sentence += " (" + entry.name + " is at " + address + ")";
  }
  return sentence;
}

}  // namespace tandem::scenario
