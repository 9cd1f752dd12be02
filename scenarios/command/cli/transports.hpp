// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/tcp/tcp.hpp"

namespace tandem::cli {

/// Files of the keys of a server.
struct ServerKeys {
  std::string
      own;  ///< secret; of zmq: the public one is beside it with .pub, of tls: the certificate with .crt
  std::vector<std::string> clients;  ///< public ones, of zmq: only
  std::string authority;             ///< certificate that the clients' are signed by, of tls: only
};
/// Listens at an address of any transport. Throws Error for keys that the transport has no use for.
std::unique_ptr<wire::Listener> listener_at(const std::string& address, const SocketSettings& settings,
                                            const ServerKeys& keys);

}  // namespace tandem::cli
