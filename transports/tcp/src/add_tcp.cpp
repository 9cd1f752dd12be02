// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/error.hpp"
#include "tandem/tcp/tcp.hpp"
#include "tandem/wire/remote_subsystem.hpp"

namespace tandem {
namespace {

SocketSettings settings_from(const Address& address, Parameters& p, bool allow_plaintext) {
  SocketSettings settings;
  settings.deadline = positive(p, "deadline", settings.deadline);
  settings.spin = 1e-6 * not_negative(p, "spin", 1e6 * settings.spin);
  settings.allow_plaintext = allow_plaintext;
  if (address.scheme != "tls") return settings;
  for (const auto& [name, file] :
       {std::pair("key", &settings.tls.key), {"authority", &settings.tls.authority}})
    if (const std::string text = p.text(name, ""); !text.empty()) *file = address.folder / text;
  return settings;
}

}  // namespace

void add_tcp(Builtins& builtins, bool allow_plaintext) {
  const auto add = [&](const std::string& scheme, auto channel) {
    builtins.addresses[scheme] = [=](const Address& address, Parameters& parameters) {
      const SocketSettings settings = settings_from(address, parameters, allow_plaintext);
      return std::make_unique<wire::RemoteSubsystem>(channel(address, settings), parameters.rest(),
                                                     settings.deadline);
    };
  };
  add("tcp", [](const Address& a, const SocketSettings& s) { return connect("tcp:" + a.place, s); });
  add("tls", [](const Address& a, const SocketSettings& s) { return connect("tls:" + a.place, s); });
  add("unix", [](const Address& a, const SocketSettings& s) {
    return connect("unix:" + (a.folder / a.place).string(), s);
  });
  add("spawn", [](const Address& a, const SocketSettings& s) {
    if (a.place.find_first_not_of(' ') == std::string::npos)
      throw Error(ErrorCode::invalid_argument,
                  "source '" + a.uri + "' names no program; allowed is spawn:COMMAND");
    return spawn(a.place, a.folder.string(), s);
  });
}

}  // namespace tandem
