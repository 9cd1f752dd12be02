// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/open.hpp"

#include <vector>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& uri, const std::string& why) {
  throw Error(ErrorCode::invalid_argument, "source '" + uri + "' " + why);
}

/// Takes "?key=value&key=value" off the end of `text` into `parameters`.
void take_query(const std::string& uri, std::string& text, Parameters& parameters) {
  const auto mark = text.find('?');
  if (mark == std::string::npos) return;
  parameters.read(text.substr(mark + 1), "source '" + uri + "'");
  text.resize(mark);
}

[[noreturn]] void refuse_builtin(const std::string& name, const Builtins& builtins) {
  std::vector<std::string> known;
  for (const auto& [key, builder] : builtins.models) known.push_back("builtin:" + key);
  throw Error(ErrorCode::invalid_argument, unknown("source", "builtin:" + name, known));
}

std::string schemes(const Builtins& builtins) {
  std::string text = "builtin:NAME";
  for (const auto& [scheme, builder] : builtins.files) text += ", " + scheme + ":FILE";
  for (const auto& [scheme, builder] : builtins.addresses) text += ", " + scheme + ":...";
  return text;
}

}  // namespace

void check_known(const std::string& uri, const Builtins& builtins) {
  const auto colon = uri.find(':');
  const std::string scheme = uri.substr(0, colon);
  if (colon == std::string::npos ||
      (scheme != "builtin" && !builtins.files.contains(scheme) && !builtins.addresses.contains(scheme)))
    refuse(uri, "has a scheme that is not known; allowed is " + schemes(builtins));
  const std::string name = uri.substr(colon + 1, uri.find('?') - colon - 1);
  if (scheme == "builtin" && !builtins.models.contains(name)) refuse_builtin(name, builtins);
}

std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Opening opening) {
  check_known(uri, builtins);
  const auto colon = uri.find(':');
  const std::string scheme = uri.substr(0, colon);
  const auto file = builtins.files.find(scheme);
  std::string name = uri.substr(colon + 1);
  Parameters& parameters = opening.parameters;
  take_query(uri, name, parameters);
  auto subsystem = scheme == "builtin" ? builtins.models.at(name)(parameters)
                   : file != builtins.files.end()
                       ? file->second(opening.folder / name, parameters)
                       : builtins.addresses.at(scheme)({uri, scheme, name, opening.folder}, parameters);
  parameters.refuse_unused("source '" + uri + "'");
  return subsystem;
}

}  // namespace tandem
