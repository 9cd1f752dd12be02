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

}  // namespace

std::unique_ptr<Subsystem> open(const std::string& uri, const Builtins& builtins, Parameters parameters) {
  const auto colon = uri.find(':');
  if (colon == std::string::npos || uri.substr(0, colon) != "builtin")
    refuse(uri, "has a scheme that is not known; allowed is builtin:NAME");
  std::string name = uri.substr(colon + 1);
  take_query(uri, name, parameters);
  const auto it = builtins.find(name);
  if (it == builtins.end()) {
    std::vector<std::string> known;
    for (const auto& [key, builder] : builtins) known.push_back("builtin:" + key);
    throw Error(ErrorCode::invalid_argument, unknown("source", "builtin:" + name, known));
  }
  auto subsystem = it->second(parameters);
  parameters.refuse_unused("source '" + uri + "'");
  return subsystem;
}

}  // namespace tandem
