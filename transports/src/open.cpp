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
  std::string query = text.substr(mark + 1) + "&";
  text.resize(mark);
  for (std::size_t begin = 0, end; (end = query.find('&', begin)) != std::string::npos; begin = end + 1) {
    const std::string pair = query.substr(begin, end - begin);
    const auto equals = pair.find('=');
    if (equals == std::string::npos || equals == 0)
      refuse(uri, "has '" + pair + "' where key=value is allowed");
    if (parameters.has(pair.substr(0, equals))) refuse(uri, "gives '" + pair.substr(0, equals) + "' twice");
    parameters.set(pair.substr(0, equals), pair.substr(equals + 1));
  }
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
  return text;
}

}  // namespace

std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Opening opening) {
  const auto colon = uri.find(':');
  const std::string scheme = uri.substr(0, colon);
  const auto file = builtins.files.find(scheme);
  if (colon == std::string::npos || (scheme != "builtin" && file == builtins.files.end()))
    refuse(uri, "has a scheme that is not known; allowed is " + schemes(builtins));
  std::string name = uri.substr(colon + 1);
  Parameters& parameters = opening.parameters;
  take_query(uri, name, parameters);
  auto subsystem = scheme == "builtin" ? find(builtins.models, name)(parameters)
                                       : file->second(opening.folder / name, parameters);
  parameters.refuse_unused("source '" + uri + "'");
  return subsystem;
}

}  // namespace tandem
