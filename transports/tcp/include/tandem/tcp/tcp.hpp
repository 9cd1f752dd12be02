// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tandem/transports/open.hpp"
#include "tandem/wire/server.hpp"

namespace tandem {

/// Files in PEM by which the two sides of "tls://HOST:PORT" know each other.
struct TlsFiles {
  /// One's own, secret; its certificate is in the file of that name with .crt for its extension.
  std::filesystem::path key = {};
  std::filesystem::path authority = {};  ///< the certificate that the other side's is signed by
};

/// How both ends of a socket wait, and what they need for TLS.
struct SocketSettings {
  double deadline = 5.0;         ///< to connect, and for the reply to a request [s]
  double spin = 50e-6;           ///< looks at the socket without a pause for so long before it sleeps [s]
  bool allow_plaintext = false;  ///< also beyond this machine
  TlsFiles tls = {};             ///< of tls:// only
};

/// Connects to "tcp://HOST:PORT", "tls://HOST:PORT" or "unix:PATH". The handshake of TLS is the first send's.
/// Throws:
/// - Error(input_output) that names the address, for a host that is not known, a connection refused or none
///   within the deadline;
/// - Error(input_output) that names the file, for a key or certificate that can't be used;
/// - Error(not_supported) for plain text beyond the loopback interface unless it is allowed, and for tls://
///   in a build without it.
std::unique_ptr<wire::Channel> connect(const std::string& address, const SocketSettings& settings);

/// Listens at "tcp://HOST:PORT", "tls://HOST:PORT" (port 0: a free one) or "unix:PATH" (readable by its owner
/// only; removed at the end). Errors as connect().
std::unique_ptr<wire::Listener> listen(const std::string& address, const SocketSettings& settings);

/// The channel of a socket that is open already, which it takes over: what spawn: leaves to its program.
std::unique_ptr<wire::Channel> adopt(int socket, const std::string& peer, const SocketSettings& settings);

/// A program that is to be started.
struct ProgramStart {
  std::vector<std::string> words;  ///< the program, which is found by PATH, and its arguments
  std::filesystem::path folder;    ///< that it works in; empty: here
  std::string name, address;       ///< what errors call the program and the channel
  bool isolates = false;           ///< has a folder for temporary files of its own, which goes with it
};

/// Starts it with one end of a private socket as the descriptor that its variable TANDEM_FD names. The
/// program and what it starts, its group of processes, end with the channel, and when this process dies.
std::unique_ptr<wire::Channel> spawn(const ProgramStart& start, const SocketSettings& settings);

/// Adds "tcp://HOST:PORT", "tls://HOST:PORT", "unix:PATH" and "spawn:COMMAND" (what `sh -c COMMAND` does, or
/// the words of Opening::command without a shell), each with ?deadline=SECONDS&spin=MICROSECONDS, tls:// also
/// with key=FILE&authority=FILE; other parameters go to the subsystem.
void add_tcp(Builtins& builtins, bool allow_plaintext = false);

}  // namespace tandem
