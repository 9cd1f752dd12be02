// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/description.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "structure.hpp"
#include "tandem/error.hpp"
#include "tandem/fmi/xml.hpp"
#include "tandem/printable.hpp"
#include "variables.hpp"

namespace tandem::fmi {
namespace {

constexpr std::uint64_t most_scalars = std::uint64_t{1} << 20;  // of an array

/// It becomes part of a file's name, so nothing that leads elsewhere.
std::string model_identifier(const Xml& xml, pugi::xml_node of) {
  const std::string name = xml.needed_text(of, "modelIdentifier");
  const bool plain =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!plain) xml.wrong(of, "modelIdentifier", "a name of letters, digits and _");
  return name;
}

std::optional<Offer> offer(const Xml& xml, pugi::xml_node of, Version version) {
  if (!of) return std::nullopt;
  const bool two = version == Version::two;
  Offer o;
  o.model = model_identifier(xml, of);
  o.needs_tool = xml.flag(of, "needsExecutionTool");
  o.once_per_process = xml.flag(of, "canBeInstantiatedOnlyOncePerProcess");
  o.keeps_state = xml.flag(of, two ? "canGetAndSetFMUstate" : "canGetAndSetFMUState");
  o.serializes_state = o.keeps_state && xml.flag(of, two ? "canSerializeFMUstate" : "canSerializeFMUState");
  o.interpolates_inputs = two && xml.flag(of, "canInterpolateInputs");
  o.needs_no_completed_steps =
      two ? xml.flag(of, "completedIntegratorStepNotNeeded") : !xml.flag(of, "needsCompletedIntegratorStep");
  o.gives_derivatives =
      xml.flag(of, two ? "providesDirectionalDerivative" : "providesDirectionalDerivatives");
  constexpr auto most = std::numeric_limits<std::int32_t>::max();
  o.derives_outputs = xml.whole(of, "maxOutputDerivativeOrder", 0, most).value_or(0) > 0;
  if (two) return o;
  o.varies_steps = xml.flag(of, "canHandleVariableCommunicationStepSize");
  o.returns_early = xml.flag(of, "mightReturnEarlyFromDoStep");
  o.has_events = xml.flag(of, "hasEventMode");
  o.asks_for_inputs = xml.flag(of, "providesIntermediateUpdate");
  o.fixed_step = xml.number(of, "fixedInternalStepSize");
  return o;
}

Version version_of(const Xml& xml, pugi::xml_node root) {
  const std::string text = xml.text(root, "fmiVersion").value_or("");
  if (text == "2.0") return Version::two;
  const bool numbers = text.find_first_not_of("0123456789.") == std::string::npos;  // none before it was done
  if (text.starts_with("3.") && numbers) return Version::three;
  xml.wrong(root, "fmiVersion", "2.0 or 3.0");
}

void read_head(const Xml& xml, pugi::xml_node root, Description& d) {
  d.version = version_of(xml, root);
  d.name = xml.needed_text(root, "modelName");
  d.guid = xml.needed_text(root, d.version == Version::two ? "guid" : "instantiationToken");
  d.tool = xml.text(root, "generationTool").value_or("");
  d.text = xml.text(root, "description").value_or("");
  d.event_indicators =
      static_cast<int>(xml.whole(root, "numberOfEventIndicators", 0, most_scalars).value_or(0));
  d.co_simulation = offer(xml, xml.only(root, "CoSimulation"), d.version);
  d.model_exchange = offer(xml, xml.only(root, "ModelExchange"), d.version);
  if (!d.co_simulation && !d.model_exchange)
    xml.refuse(root, std::string("the FMU offers ") +
                         (root.child("ScheduledExecution") ? "Scheduled Execution alone" : "no interface") +
                         "; allowed are Co-Simulation and Model Exchange");
  const pugi::xml_node experiment = root.child("DefaultExperiment");
  d.experiment = {xml.number(experiment, "stepSize"), xml.number(experiment, "tolerance")};
}

/// Of a dimension; more than are allowed where it is not known.
std::uint64_t extent(const Dimension& one, const Description& d) {
  if (one.variable < 0) return std::min(one.size, most_scalars + 1);
  const std::vector<double>& start = d.at(one.variable).start_values;
  const bool known = start.size() == 1 && start[0] >= 0.0 && start[0] <= static_cast<double>(most_scalars) &&
                     start[0] == std::floor(start[0]);
  return known ? static_cast<std::uint64_t>(start[0]) : most_scalars + 1;
}

int size_of(const Variable& v, const Description& d) {
  std::uint64_t size = 1;
  for (const Dimension& one : v.dimensions)
    if ((size *= extent(one, d)) > most_scalars)
      throw Error(ErrorCode::invalid_argument, "the FMU's array '" + printable(v.name, 200) +
                                                   "' has a size that is not known, or more than " +
                                                   std::to_string(most_scalars) + " elements");
  return static_cast<int>(size);
}

void check_states(const Description& d) {
  for (const Unknown& rate : d.derivatives) {
    const Variable &v = d.at(rate.variable), &state = d.at(v.derivative_of);
    if (v.size != state.size)
      throw Error(ErrorCode::invalid_argument, "the FMU's derivative '" + printable(v.name, 200) + "' has " +
                                                   std::to_string(v.size) + " elements and its state " +
                                                   std::to_string(state.size) + "; allowed are as many");
  }
}

}  // namespace

Description read_description(const std::string& text, const std::string& file) {
  const Xml xml(text, file);
  const pugi::xml_node root = xml.root("fmiModelDescription");
  Description d;
  read_head(xml, root, d);
  d.variables = read_variables(xml, root, d.version);
  read_structure(xml, root.child("ModelStructure"), d);
  set_sizes(d);
  return d;
}

void set_sizes(Description& d) {
  std::uint64_t all = 0;
  for (Variable& v : d.variables) all += static_cast<std::uint64_t>(v.size = size_of(v, d));
  if (constexpr std::uint64_t most = std::uint64_t{1} << 26; all > most)
    throw Error(ErrorCode::invalid_argument, "the FMU's variables have " + std::to_string(all) +
                                                 " elements; allowed are " + std::to_string(most));
  check_states(d);
  if (d.version == Version::two) return;
  d.event_indicators = 0;
  for (const int one : d.indicators) d.event_indicators += d.at(one).size;
}

int Description::state_size() const {
  int size = 0;
  for (const Unknown& rate : derivatives) size += at(rate.variable).size;
  return size;
}

}  // namespace tandem::fmi
