// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "tandem/transports/open.hpp"
#include "tandem/wire/server.hpp"

namespace tandem {

/// How both ends of a socket wait.
struct SocketSettings {
  double deadline = 5.0;         ///< to connect, and for the reply to a request [s]
  double spin = 50e-6;           ///< looks at the socket without a pause for so long before it sleeps [s]
  bool allow_plaintext = false;  ///< also beyond this machine
};

/// Connects to "tcp://HOST:PORT" or "unix:PATH". Throws Error(input_output) that names the address for a host
/// that is not known, a connection refused or none within the deadline; Error(not_supported) for one beyond
/// the loopback interface unless plain text is allowed.
std::unique_ptr<wire::Channel> connect(const std::string& address, const SocketSettings& settings);

/// Listens at "tcp://HOST:PORT" (port 0: a free one) or "unix:PATH" (readable by its owner only; removed at
/// the end). Errors as connect().
std::unique_ptr<wire::Listener> listen(const std::string& address, const SocketSettings& settings);

/// The channel of a socket that is open already, which it takes over: what spawn: leaves to its program.
std::unique_ptr<wire::Channel> adopt(int socket, const std::string& peer, const SocketSettings& settings);

/// Starts "COMMAND" by the shell in `folder` (empty: here), with one end of a private socket as the
/// descriptor that its variable TANDEM_FD names. The program is ended with the channel, and when this process
/// dies.
std::unique_ptr<wire::Channel> spawn(const std::string& command, const std::string& folder,
                                     const SocketSettings& settings);

/// Adds "tcp://HOST:PORT", "unix:PATH" and "spawn:COMMAND", each with ?deadline=SECONDS&spin=MICROSECONDS;
/// other parameters go to the subsystem.
void add_tcp(Builtins& builtins, bool allow_plaintext = false);

}  // namespace tandem
