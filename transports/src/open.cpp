// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/open.hpp"

#include <vector>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem {
namespace {

void take_query(const std::string& uri, Parameters& to) {
  if (uri.find('?') != std::string::npos) to.read(SourceUri(uri).query, "source '" + uri + "'");
}

[[noreturn]] void refuse_builtin(const std::string& name, const Builtins& builtins) {
  std::vector<std::string> known;
  for (const auto& [key, source] : builtins.models) known.push_back("builtin:" + key);
  throw Error(ErrorCode::invalid_argument, unknown("source", "builtin:" + name, known));
}

std::string schemes(const Builtins& builtins) {
  std::string text = "builtin:NAME";
  for (const auto& [scheme, source] : builtins.schemes)
    text += ", " + scheme + (source.elsewhere ? ":..." : ":FILE");
  return text;
}

/// A URI taken apart, with its parameters beside the others; those that are the source's own are declared.
Address taken_apart(const std::string& uri, const Source& source, Opening& opening) {
  const SourceUri parts(uri);
  Address address{
      uri, parts.scheme, parts.place, opening.folder, opening.command, opening.overrides, opening.isolated};
  take_query(uri, opening.parameters);
  opening.parameters.declare(source.words);
  opening.parameters.refuse_foreign(address.name());
  return address;
}

/// An error of a parameter is told with the source.
template <class Work>
auto named(const Address& address, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const Error& error) {
    const std::string sentence = error.what();
    if (!sentence.starts_with("parameter '")) throw;
    throw Error(error.code(), address.name() + ": " + sentence);
  }
}

std::unique_ptr<Subsystem> made(const std::string& uri, const Source& source, Opening opening) {
  const Address address = taken_apart(uri, source, opening);
  auto subsystem = named(address, [&] { return source.make(address, opening.parameters); });
  opening.parameters.refuse_unused(address.name());
  return subsystem;
}

void check_isolated(const std::string& uri, const Source& source, const Builtins& builtins) {
  if (!source.native)
    throw Error(ErrorCode::invalid_argument,
                "isolate is true beside source '" + printable(uri) +
                    "'; allowed is it beside native code, lib:, three_functions:, functions: or fmu:");
  if (builtins.server.empty())
    throw Error(ErrorCode::not_supported,
                "isolate is true, but there is no program here that serves a source");
}

/// The parameters of the way to a program of its own.
Parameters take_outside(Parameters& all, const Builtins& builtins) {
  Parameters outside;
  for (const Word& word : source_of("spawn:", builtins).words)
    if (all.has(word.name)) outside.set(word.name, all.number(word.name, 0.0));
  return outside;
}

/// The same source in a program of its own, which is handed all other parameters.
std::unique_ptr<Subsystem> open_isolated(std::string uri, const Source& source, const Builtins& builtins,
                                         Opening opening) {
  check_isolated(uri, source, builtins);
  Opening outside{take_outside(opening.parameters, builtins), opening.folder, builtins.server, {}, true};
  if (const std::string rest = opening.parameters.rest_escaped(); !rest.empty())
    uri += (uri.find('?') == std::string::npos ? "?" : "&") + rest;
  outside.command.push_back(std::move(uri));
  return made("spawn:", source_of("spawn:", builtins), std::move(outside));
}

}  // namespace

const Source& source_of(const std::string& uri, const Builtins& builtins) {
  const SourceUri parts(uri);
  if (parts.scheme == "builtin") {
    const auto model = builtins.models.find(parts.place);
    if (model == builtins.models.end()) refuse_builtin(parts.place, builtins);
    return model->second;
  }
  const auto source = builtins.schemes.find(parts.scheme);
  if (source == builtins.schemes.end())
    throw Error(ErrorCode::invalid_argument,
                "source '" + uri + "' has a scheme that is not known; allowed is " + schemes(builtins));
  return source->second;
}

std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Opening opening) {
  const Source& source = source_of(uri, builtins);
  if (opening.isolated) return open_isolated(uri, source, builtins, std::move(opening));
  return made(uri, source, std::move(opening));
}

std::optional<Look> look_at(const std::string& uri, const Builtins& builtins, Opening opening) {
  const Source& source = source_of(uri, builtins);
  if (opening.isolated) {
    check_isolated(uri, source, builtins);
    take_outside(opening.parameters, builtins);
  }
  const Address address = taken_apart(uri, source, opening);
  if (!source.look) return std::nullopt;
  auto seen = named(address, [&] { return source.look(address, opening.parameters); });
  opening.parameters.refuse_unused(address.name());
  return seen;
}

Parameters query_of(const std::string& uri) {
  Parameters all;
  take_query(uri, all);
  return all;
}

std::string Address::name() const {
  return command.empty() ? "source '" + printable(uri) + "'" : "command " + shown(command);
}

std::string shown(const std::vector<std::string>& command) {
  std::string text;
  for (const std::string& word : command) {
    text += text.empty() ? "\"" : ", \"";
    for (const char c : word) text += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    text += '"';
  }
  return "[" + printable(text) + "]";
}

}  // namespace tandem
