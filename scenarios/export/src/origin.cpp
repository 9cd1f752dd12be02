// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "origin.hpp"

#include "tandem/error.hpp"
#include "tandem/exported/sources.hpp"
#include "tandem/files_read.hpp"
#include "tandem/scenario/file_text.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/text/document.hpp"
#include "tandem/text/file_parameters.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem::exported {
namespace {

namespace fs = std::filesystem;

const Builtins& plain_sources() {
  static const Builtins all = sources();
  return all;
}

[[noreturn]] void refuse(const std::string& source, const std::string& what) {
  throw Error(
      ErrorCode::invalid_argument,
      source + " is " + what +
          "; allowed are the file of a mechanism, a diagram or a scenario, mechanism:FILE, diagram:FILE and "
          "scenario:FILE");
}

/// The parts of a URI, or a file with what it is.
Origin named(const std::string& source) {
  const SourceUri uri(source);
  if (plain_sources().schemes.contains(uri.scheme)) return {uri.scheme, uri.place, {}, {}};
  if (!uri.scheme.empty() && !fs::exists(source)) refuse(source, "a source that does not go along");
  if (fs::path(source).extension() == ".fmu") refuse(source, "an FMU already");
  if (scenario::is_system(source)) refuse(source, "a system of FMUs, which don't go along in another");
  const std::string kind = scenario::kind_alone(source);
  return {kind.empty() ? "scenario" : kind, source, {}, {}};
}

void take_scenario(Origin& to) {
  const scenario::Scenario all = scenario::read(to.file, to.overrides);
  to.span = TimeSpan{all.start, all.stop};
}

/// The table [run].
void take_run(const text::Document& document, Origin& to) {
  const auto run = document.table()["run"];
  if (!run) return;
  std::vector<std::string> overrides = to.overrides;
  if (!run["stop"]) overrides.push_back("run.stop=1e9");  // of a run; it belongs to no FMU
  const scenario::Scenario alone = scenario::read(to.file, overrides);
  if (run["stop"]) to.span = TimeSpan{alone.start, alone.stop};
  for (const scenario::Parameter& p : alone.subsystems.at(0).parameters) to.parameters[p.name] = p.value;
  for (const scenario::InputEntry& input : alone.subsystems.at(0).inputs)
    to.starts[input.port] = input.at(alone.start);
}

void take_file(const std::optional<Member>& member, Origin& to) {
  text::Document document(to.file);
  document.set(to.overrides);
  to.name = document.table()["name"].value_or(to.file.stem().string());
  to.description = document.table()["description"].value_or(std::string());
  if (to.scheme == "scenario")
    take_scenario(to);
  else if (!member)
    take_run(document, to);
  if (!member) return;
  to.parameters = member->parameters, to.starts = member->starts, to.span = member->span;
}

void open_with(const Origin& origin, const std::string& name, const std::string& word) {
  Opening opening = origin.opening();
  opening.parameters.set(name, word);
  open(origin.uri(), plain_sources(), std::move(opening));
}

/// Whatever word a parameter is set to by a list of its file.
void open_with_each_word(const Origin& origin) {
  Parameters none;
  for (const text::FileParameter& parameter :
       scenario::parameters_of(origin.uri(), {}, origin.overrides, none))
    for (const std::string& word : parameter.allowed) open_with(origin, parameter.name, word);
}

}  // namespace

Opening Origin::opening() const {
  Opening opening{{}, {}, {}, overrides};
  for (const auto& [key, value] : parameters) opening.parameters.set(key, value);
  return opening;
}

Origin read_origin(const ExportSettings& settings) {
  const std::string& source = settings.source;
  Origin origin = named(source);
  origin.overrides = settings.overrides;
  take_file(settings.member, origin);
  Parameters given = origin.file == source ? Parameters() : query_of(source);
  for (const std::string& name : given.names("")) origin.parameters[name] = given.text(name, "");
  return origin;
}

std::vector<fs::path> files_of(const Origin& origin, const Builtins& here) {
  const FilesRead read;
  try {
    open(origin.uri(), plain_sources(), origin.opening());
  } catch (const Error& error) {
    if (error.code() == ErrorCode::not_supported) throw;
    open(origin.uri(), here, origin.opening());
    throw Error(error.code(), std::string(error.what()) +
                                  ". This program has it, written in C++; an FMU has what the pages of "
                                  "mechanisms and diagrams list");
  }
  open_with_each_word(origin);
  return {read.files().begin(), read.files().end()};
}

}  // namespace tandem::exported
