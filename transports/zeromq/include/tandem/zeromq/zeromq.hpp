// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tandem/transports/open.hpp"
#include "tandem/wire/server.hpp"

namespace tandem {

/// A pair of CURVE keys, each 40 characters of Z85.
struct CurveKeys {
  std::string public_key, secret_key;
};
CurveKeys make_curve_keys();
/// The key in a file. Throws Error(input_output) for a file that is not there or holds no key, and, of a
/// `secret` one, if others than its owner may read it.
std::string read_curve_key(const std::filesystem::path& file, bool secret);

struct ZmqSettings {
  double deadline = 5.0;                  ///< for the reply to a request [s]
  bool allow_plaintext = false;           ///< without keys also beyond this machine
  CurveKeys keys = {};                    ///< one's own; empty: plain text
  std::string server_key = {};            ///< of a client: the server's public key
  std::vector<std::string> clients = {};  ///< of a server: the public keys that it lets in
};

/// Connects to "tcp://HOST:PORT", "ipc://PATH" or "inproc://NAME". A server answers a knock at its address
/// with that of a socket for this session alone. Throws Error as tandem::connect does.
std::unique_ptr<wire::Channel> zmq_connect(const std::string& address, const ZmqSettings& settings);
std::unique_ptr<wire::Listener> zmq_listen(const std::string& address, const ZmqSettings& settings);

/// Adds "zmq:ADDRESS?deadline=SECONDS&key=FILE&server_key=FILE"; other parameters go to the subsystem. `key`
/// is the file of the secret key, with the public one in FILE.pub.
void add_zeromq(Builtins& builtins, bool allow_plaintext = false);

}  // namespace tandem
