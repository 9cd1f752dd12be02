// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/error.hpp"
#include "tandem/printable.hpp"
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

/// The words of a command as they are, or a line for the shell.
ProgramStart program_of(const Address& a) {
  const bool shell = a.command.empty();
  if (shell ? a.place.find_first_not_of(' ') == std::string::npos : a.command[0].empty())
    throw Error(ErrorCode::invalid_argument, a.name() + " names no program; allowed is " +
                                                 (shell ? "spawn:COMMAND" : "a text that is not empty"));
  ProgramStart start{a.command, a.folder, shown(a.command), "command " + shown(a.command), a.isolated};
  if (a.isolated)
    start.name = "'" + printable(a.command.back()) + "'", start.address = "isolated " + start.name;
  if (shell) start = {{"/bin/sh", "-c", a.place}, a.folder, "'" + a.place + "'", "spawn:" + a.place};
  for (const std::string& word : start.words)
    if (word.find('\0') != std::string::npos)
      throw Error(ErrorCode::invalid_argument,
                  a.name() + " holds a character 0, where a program's arguments end");
  return start;
}

std::optional<Look> look_at_program(const Address& address, Parameters& parameters) {
  program_of(address);
  settings_from(address, parameters, false);
  parameters.rest();
  return std::nullopt;
}

}  // namespace

void add_tcp(Builtins& builtins, bool allow_plaintext) {
  const auto add = [&](const std::string& scheme, auto channel) {
    Words own = words_by(Setter::operator_only, {"deadline", "spin"});
    if (scheme == "tls") own = own + words_by(Setter::operator_only, {"key", "authority"});
    const auto make = [=](const Address& address, Parameters& parameters) {
      const SocketSettings settings = settings_from(address, parameters, allow_plaintext);
      return std::make_unique<wire::RemoteSubsystem>(channel(address, settings), parameters.rest(),
                                                     settings.deadline);
    };
    builtins.schemes[scheme] = {own, make, true};
  };
  add("tcp", [](const Address& a, const SocketSettings& s) { return connect("tcp:" + a.place, s); });
  add("tls", [](const Address& a, const SocketSettings& s) { return connect("tls:" + a.place, s); });
  add("unix", [](const Address& a, const SocketSettings& s) {
    return connect("unix:" + (a.folder / a.place).string(), s);
  });
  add("spawn", [](const Address& a, const SocketSettings& s) { return spawn(program_of(a), s); });
  builtins.schemes["spawn"].code = true;
  builtins.schemes["spawn"].look = look_at_program;
}

}  // namespace tandem
