// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/diagram.hpp"

#include <utility>

#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"
#include "tandem/error.hpp"
#include "tandem/sources/file_parameters.hpp"
#include "tandem/sources/integrators.hpp"
#include "tandem/sources/run_table.hpp"

namespace tandem {
namespace {

Words diagram_words() { return words_by(Setter::client, {"step", "locate_events"}) + integrator_words(); }

/// The diagram with the parameters that are given.
engine::Description read(const text::Document& document, Parameters& p) {
  const text::GivenValues values = take_file_parameters(document, diagram_words(), p);
  engine::FileBounds bounds{std::filesystem::path(document.file()).parent_path(), {}};
  for (const auto& [name, value] : values)
    if (p.from_client(name)) bounds.parameters.insert(name);
  return engine::read_diagram(document, values, bounds);
}

}  // namespace

engine::Description describe_diagram(const SourceFile& file, Parameters& p) {
  p.declare(diagram_words());
  const text::Document document = file.document();
  take_run_table(document, p);
  return read(document, p);
}

namespace {

/// A diagram, and what it is run with.
struct Prepared {
  engine::Description diagram;
  engine::SubsystemSettings settings = {};
};

Prepared prepare(const SourceFile& file, Parameters& p, std::vector<engine::CompiledBlock> kinds,
                 const TellOfDiagram& tell) {
  Prepared made{describe_diagram(file, p)};
  made.diagram.kinds = std::move(kinds);
  engine::SubsystemSettings& settings = made.settings;
  settings.step = p.number("step", 0.0);
  settings.integrator.name = p.text("integrator", settings.integrator.name);
  settings.integrator.locate_events = p.flag("locate_events", settings.integrator.locate_events);
  take_adaptive(p, settings.integrator.adaptive);
  if (tell)
    settings.simulation.tell = [tell, name = made.diagram.name](const std::string& text) {
      tell("diagram '" + name + "': " + text);
    };
  return made;
}

}  // namespace

std::unique_ptr<Subsystem> make_diagram(const SourceFile& file, Parameters& p,
                                        std::vector<engine::CompiledBlock> kinds, const TellOfDiagram& tell) {
  const Prepared made = prepare(file, p, std::move(kinds), tell);
  return engine::make_subsystem(made.diagram, made.settings);
}

std::unique_ptr<engine::ExchangedDiagram> exchanged_diagram(const SourceFile& file, Parameters& p,
                                                            const TellOfDiagram& tell) {
  const Prepared made = prepare(file, p, {}, tell);
  return std::make_unique<engine::ExchangedDiagram>(made.diagram, made.settings.step,
                                                    made.settings.simulation);
}

Source diagram_source(const std::vector<engine::CompiledBlock>& kinds, const TellOfDiagram& tell) {
  return {diagram_words(), [kinds, tell](const Address& address, Parameters& p) {
            return make_diagram({address.file(), {}, address.overrides}, p, kinds, tell);
          }};
}

}  // namespace tandem
