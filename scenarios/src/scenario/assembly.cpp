// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/assembly.hpp"

#include <algorithm>

#include "tandem/nearest.hpp"

namespace tandem::scenario {

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
                 [&] { return open(entry.source, builtins, std::move(opening)); });
}

void Assembly::check_judge() const {
  std::vector<std::string> outputs;
  for (int i = 0; i < topology_.size(); ++i)
    for (int k = 0; k < topology_.info(i).output_size(); ++k) outputs.push_back(topology_.output_name(i, k));
  const JudgeEntry& judge = *scenario_.judge;
  if (std::find(outputs.begin(), outputs.end(), judge.quantity) == outputs.end())
    refuse(judge.place, unknown("judge.quantity: output", judge.quantity, outputs));
}

std::unique_ptr<Recorder> Assembly::recorder(const std::filesystem::path& directory) const {
  Recording recording = scenario_.recording;
  recording.directory = directory;
  return located(scenario_.place("record.ports"),
                 [&] { return std::make_unique<Recorder>(*coordinator_, recording); });
}

void Assembly::initialize() {
  located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
          [&] { coordinator_->initialize(); });
}

}  // namespace tandem::scenario
