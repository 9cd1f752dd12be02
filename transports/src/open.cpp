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

template <class Builders>
const typename Builders::mapped_type& find(const Builders& builders, const std::string& name) {
  const auto it = builders.find(name);
  if (it != builders.end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [key, builder] : builders) known.push_back("builtin:" + key);
  throw Error(ErrorCode::invalid_argument, unknown("source", "builtin:" + name, known));
}

std::string schemes(const Builtins& builtins) {
  std::string text = "builtin:NAME";
  for (const auto& [scheme, builder] : builtins.files) text += ", " + scheme + ":FILE";
  for (const auto& [scheme, builder] : builtins.addresses) text += ", " + scheme + ":...";
  return text;
}

}  // namespace

std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Opening opening) {
  const auto colon = uri.find(':');
  const std::string scheme = uri.substr(0, colon);
  const auto file = builtins.files.find(scheme);
  const auto address = builtins.addresses.find(scheme);
  const bool known =
      scheme == "builtin" || file != builtins.files.end() || address != builtins.addresses.end();
  if (colon == std::string::npos || !known)
    refuse(uri, "has a scheme that is not known; allowed is " + schemes(builtins));
  std::string name = uri.substr(colon + 1);
  Parameters& parameters = opening.parameters;
  take_query(uri, name, parameters);
  auto subsystem = scheme == "builtin" ? find(builtins.models, name)(parameters)
                   : file != builtins.files.end()
                       ? file->second(opening.folder / name, parameters)
                       : address->second({uri, scheme, name, opening.folder}, parameters);
  parameters.refuse_unused("source '" + uri + "'");
  return subsystem;
}

}  // namespace tandem
