// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "origin.hpp"

#include "tandem/error.hpp"
#include "tandem/files_read.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/text/document.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::exported {
namespace {

namespace fs = std::filesystem;

const Builtins& plain_sources() {
  static const Builtins all{{}, {{"diagram", diagram_source()}, {"mechanism", mechanism_source()}}};
  return all;
}

[[noreturn]] void refuse(const std::string& source, const std::string& what) {
  throw Error(ErrorCode::invalid_argument,
              source + " is " + what +
                  "; allowed are the file of a mechanism or a diagram, mechanism:FILE and diagram:FILE");
}

/// The parts of a URI, or a file with what it is.
Origin named(const std::string& source) {
  const auto colon = source.find(':'), question = source.find('?');
  const std::string scheme = source.substr(0, colon);
  if (colon != std::string::npos && plain_sources().schemes.contains(scheme))
    return {scheme, source.substr(colon + 1, question - colon - 1), {}, {}};
  if (colon != std::string::npos && !fs::exists(source)) refuse(source, "a source that does not go along");
  const std::string kind = scenario::kind_alone(source);
  if (kind.empty()) refuse(source, "a scenario, which becomes FILE.ssp");
  return {kind, source, {}, {}};
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
  if (!member) return take_run(document, to);
  to.parameters = member->parameters, to.starts = member->starts, to.span = member->span;
}

void open_with(const Origin& origin, const std::string& name, const std::string& word) {
  Opening opening = origin.opening();
  opening.parameters.set(name, word);
  open(origin.uri(), plain_sources(), std::move(opening));
}

/// Whatever word a parameter is set to by a list of its file.
void open_with_each_word(const Origin& origin) {
  text::Document document(origin.file);
  document.set(origin.overrides);
  for (const text::FileParameter& parameter : text::parameters_of(document, {}))
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
  Parameters given;
  if (const auto question = source.find('?'); question != std::string::npos && origin.file != source)
    given.read(source.substr(question + 1), source);
  for (const std::string& name : given.names("")) origin.parameters[name] = given.text(name, "");
  if (origin.parameters.contains("matrices"))
    throw Error(ErrorCode::invalid_argument,
                source + ": 'matrices' names a folder of this machine; an FMU writes no files");
  return origin;
}

std::vector<fs::path> files_of(const Origin& origin, const Builtins& here) {
  const FilesRead read;
  try {
    open(origin.uri(), plain_sources(), origin.opening());
  } catch (const Error& error) {
    open(origin.uri(), here, origin.opening());
    throw Error(error.code(), std::string(error.what()) +
                                  ". This program has it, written in C++; an FMU has what the pages of "
                                  "mechanisms and diagrams list");
  }
  open_with_each_word(origin);
  return {read.files().begin(), read.files().end()};
}

}  // namespace tandem::exported
