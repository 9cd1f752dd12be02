// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/fmi.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "co_simulation.hpp"
#include "fmu.hpp"
#include "instance.hpp"
#include "library_look.hpp"
#include "model_exchange.hpp"
#include "tandem/error.hpp"
#include "tandem/fmi/platform.hpp"
#include "tandem/printable.hpp"

namespace tandem {
namespace fmi {
namespace {

std::string described(const Fmu& fmu) {
  const Description& d = fmu.description;
  std::string text =
      fmt::format("FMI {}.0, {}", d.version == Version::two ? 2 : 3, name_of(fmu.settings.kind));
  if (d.co_simulation && d.model_exchange)
    text += fmt::format(
        " (it offers {}, too)",
        name_of(fmu.settings.kind == Kind::co_simulation ? Kind::model_exchange : Kind::co_simulation));
  if (!d.tool.empty()) text += "; made by " + printable(d.tool, 200);
  if (!d.text.empty()) text += "; " + printable(d.text, 500);
  return text;
}

/// FMI 3.0 returns the time that a step has come to.
bool can_tell_its_time(const Fmu& fmu) {
  const auto& all = fmu.description.variables;
  return fmu.description.version == Version::three || fmu.settings.kind == Kind::model_exchange ||
         std::any_of(all.begin(), all.end(),
                     [](const Variable& v) { return v.causality == Causality::independent; });
}

std::string states_sentence(const Fmu& fmu) {
  const Description& d = fmu.description;
  const Offer& offer = offer_of(d, fmu.settings.kind);
  return fmt::format(
      "{} continuous states, {} event indicators; its state can{} be had{}; it takes{} derivatives of "
      "inputs{}",
      d.state_size(), d.event_indicators, offer.keeps_state ? "" : "not",
      offer.serializes_state ? ", also as bytes" : "", offer.interpolates_inputs ? "" : " no",
      offer.gives_derivatives ? ", and gives directional ones" : "");
}

/// As far as they can be declared.
DeclaredParameters parameters_of(const Fmu& fmu) {
  DeclaredParameters all;
  for (const Variable& v : fmu.description.variables) {
    const bool is_parameter =
        v.causality == Causality::parameter || v.causality == Causality::structural_parameter;
    if (!is_parameter || (!is_number(v.type) && v.type != Type::text)) continue;
    DeclaredParameter p{"set." + v.name, {}, v.start.value_or(""), v.description};
    const bool has_unit = is_number(v.type) && v.type != Type::boolean && v.dimensions.empty();
    if (has_unit) p.unit = v.unit;
    all.push_back(std::move(p));
  }
  return all;
}

/// Why the FMU can't be run here, as far as is seen without its code; empty: nothing is seen against it.
std::string obstacle_of(const Fmu& fmu) {
  if (offer_of(fmu.description, fmu.settings.kind).needs_tool)
    return "needs the tool that made it (needsExecutionTool); allowed is one that brings all that it needs";
  for (const Variable& v : fmu.description.variables)
    if (v.type == Type::clock && v.causality == Causality::input)
      return "has a clock, '" + printable(v.name, 200) +
             "', that its importer would have to tick; allowed is one without input clocks";
  return library_obstacle(fmu);
}

std::vector<bool> discrete_inputs(const Ports& ports) {
  std::vector<bool> discrete(static_cast<std::size_t>(ports.info.input_size()), false);
  for (const Seat& seat : ports.discrete)
    for (int k = 0; k < seat.size; ++k) discrete[static_cast<std::size_t>(seat.place + k)] = true;
  return discrete;
}

Look look(const Fmu& fmu) {
  Look seen{fmu.ports.info,
            parameters_of(fmu),
            fmu.settings.step,
            fmu.settings.input_order(),
            offer_of(fmu.description, fmu.settings.kind).once_per_process,
            discrete_inputs(fmu.ports),
            {described(fmu), "library: " + library_of(fmu), states_sentence(fmu)},
            obstacle_of(fmu)};
  if (!can_tell_its_time(fmu))
    seen.sentences.emplace_back(
        "no variable is its time, so a step that it does not do and says that it has goes unseen");
  if (!seen.obstacle.empty()) seen.obstacle = "the FMU " + seen.obstacle;
  return seen;
}

void require_runnable(const Fmu& fmu) {
  const std::string who = "FMU '" + fmu.file.string() + "'";
  if (fmu.settings.step == 0.0)
    throw Error(ErrorCode::invalid_argument,
                who +
                    " names no step of its own (fixedInternalStepSize, DefaultExperiment stepSize); give the "
                    "parameter step, a number above 0 [s]");
  if (const std::string obstacle = obstacle_of(fmu); !obstacle.empty())
    throw Error(ErrorCode::not_supported, who + " " + obstacle);
}

std::unique_ptr<Subsystem> make(const Address& address, Parameters& p, const Tell& tell,
                                const FmuIntegrators& integrators) {
  Fmu fmu = read_fmu(address.file(), p, integrators);
  p.refuse_unused(address.name());
  require_runnable(fmu);
  const Kind kind = fmu.settings.kind;
  auto instance = Instance::make(std::move(fmu), tell);
  return kind == Kind::co_simulation ? make_co_simulation(std::move(instance))
                                     : make_model_exchange(std::move(instance));
}

}  // namespace

Fmu read_fmu(const std::filesystem::path& file, Parameters& parameters, const FmuIntegrators& integrators) {
  Fmu fmu{file, std::make_unique<Archive>(file), {}, {}, {}};
  fmu.description = description_of(*fmu.archive, file);
  fmu.settings = take_settings(fmu.description, parameters, integrators);
  fmu.ports = ports_of(fmu.description, fmu.settings);
  return fmu;
}

std::string library_of(const Fmu& fmu) {
  return binaries_of_this_platform(fmu.description.version) +
         offer_of(fmu.description, fmu.settings.kind).model + ".so";
}

}  // namespace fmi

void add_fmi(Builtins& builtins, const std::function<void(const std::string&)>& tell,
             const FmuIntegrators& integrators) {
  builtins.schemes["fmu"] = {fmi::fmu_words() + integrators.words,
                             [tell, integrators](const Address& address, Parameters& p) {
                               return fmi::make(address, p, tell, integrators);
                             },
                             false,
                             true,
                             [integrators](const Address& address, Parameters& p) {
                               return fmi::look(fmi::read_fmu(address.file(), p, integrators));
                             },
                             true};
}

}  // namespace tandem
