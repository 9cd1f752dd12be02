// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/export/system.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "system_description.hpp"
#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/provenance.hpp"
#include "tandem/transports/temporary_folder.hpp"
#include "zip.hpp"

namespace tandem::exported {
namespace {

constexpr std::uint64_t largest_system = std::uint64_t{1} << 30;

bool reads(const SystemMember& member, const scenario::ConnectionEntry& entry) {
  return entry.connection.how && entry.connection.to.starts_with(member.name + ".");
}

/// Of the polynomials that it reads; -1: all its inputs are constants.
int degree_of_inputs(const SystemMember& member, const scenario::Scenario& scenario) {
  int degree = -1;
  for (const scenario::ConnectionEntry& entry : scenario.connections)
    if (entry.connection.to.starts_with(member.name + "."))
      degree = std::max(degree, entry.connection.how ? entry.connection.how->polynomial_degree() : 0);
  return degree;
}

/// A polynomial goes into an FMU of 2.0 as derivatives; more than two of them tandem does not give. A constant, too: then
/// derivatives of outputs that follow an input at once are known, and the run starts by them.
void give_derivatives(SystemMember& member, const scenario::Scenario& scenario, fmi::Version version,
                      std::vector<std::string>& told) {
  if (!member.source || member.source->inputs.empty()) return;
  const int degree = degree_of_inputs(member, scenario);
  if (degree == 0 || (degree < 0 && version != fmi::Version::two)) return;
  if (version != fmi::Version::two)
    return told.push_back(
        fmt::format("{}: inputs of degree {} are given as their mean over each step, as FMI 3.0 "
                    "has no derivatives of inputs; the run that comes back differs",
                    member.name, degree));
  const int order = std::clamp(degree, 1, 2);
  member.annotation["inputs"] = "derivatives", member.annotation["order"] = std::to_string(order);
  if (order < degree)
    told.push_back(fmt::format("{}: inputs of degree {} are given by derivatives of order {}", member.name,
                               degree, order));
}

bool is_shorter(const std::optional<double>& a, const std::optional<double>& b) { return a && b && *a < *b; }

/// Of a source with shorter steps an input is several polynomials within a step.
void tell_of_shorter_steps(const SystemMember& member, const std::vector<SystemMember>& all,
                           const scenario::Scenario& scenario, std::vector<std::string>& told) {
  for (const SystemMember& source : all)
    for (const scenario::ConnectionEntry& entry : scenario.connections)
      if (member.source && reads(member, entry) && entry.connection.how->polynomial_degree() > 0 &&
          entry.connection.from.starts_with(source.name + ".") &&
          is_shorter(source.description.experiment.step, member.description.experiment.step)) {
        told.push_back(
            fmt::format("{}: {} has shorter steps, and within a step its outputs go on as at the step's "
                        "begin; the run that comes back differs",
                        member.name, source.name));
        break;
      }
}

/// As its user will.
void read_back(const std::filesystem::path& system, const scenario::Scenario& of, const Builtins& here) try {
  const scenario::Scenario again = scenario::read(system);
  const scenario::Parts parts(again, here, scenario::Code::leave_out);
} catch (const Error& error) {
  const std::string sentence = error.what();
  const auto place = sentence.find(": ");  // in a file that goes
  throw Error(error.code(), of.file.string() + ": the system that it becomes can't be read: " +
                                sentence.substr(place == std::string::npos ? 0 : place + 2));
}

void tell_of_samples(const SystemMember& member, std::vector<std::string>& told) {
  if (member.source && member.source->abilities.sampled)
    told.push_back(member.name +
                   ": samples, and comes back as one that integrates itself, with its period for a step");
}

void tell_of_events(const SystemMember& member, std::vector<std::string>& told) {
  if (member.source && member.source->abilities.events && !member.source->abilities.sampled)
    told.push_back(
        member.name +
        ": has events, which others see at the ends of its steps alone; the run that comes back differs");
}

}  // namespace

std::vector<std::string> export_system(const SystemSettings& settings, const Builtins& here) {
  const scenario::Scenario scenario = scenario::read(settings.scenario, settings.overrides);
  const scenario::Parts parts(scenario, here, scenario::Code::leave_out);
  const TemporaryFolder folder;
  std::vector<std::string> told;
  std::vector<SystemMember> members;
  std::map<std::string, std::string> contents;
  for (int k = 0; k < parts.topology().size(); ++k) {
    members.push_back(member_of(scenario, parts, k, settings, folder.path(), here));
    SystemMember& member = members.back();
    give_derivatives(member, scenario, settings.version, told);
    tell_of_samples(member, told);
    tell_of_events(member, told);
    contents["resources/" + file_of(member.name)] = std::move(member.fmu);
  }
  for (const SystemMember& member : members) tell_of_shorter_steps(member, members, scenario, told);
  contents["SystemStructure.ssd"] = system_description(scenario, members, "tandem " + output::version());
  const auto made = folder.path() / "made.ssp";
  write_zip(made, contents);
  read_back(made, scenario, here);
  output::replace_text(settings.file, read_file(made, largest_system));
  told.insert(told.begin(), fmt::format("{}: SSP 1.0, {} components, {} connections, {:.2f} MB",
                                        settings.file.string(), members.size(), scenario.connections.size(),
                                        static_cast<double>(std::filesystem::file_size(made)) * 1e-6));
  return told;
}

}  // namespace tandem::exported
