// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/asio/ip/tcp.hpp>
#include <string>
#include <vector>

#include "socket_stream.hpp"

namespace tandem::tcp {

using Endpoint = boost::asio::generic::stream_protocol::endpoint;

/// Where "tcp://HOST:PORT" or "unix:PATH" is.
struct Place {
  std::string scheme, host, port, path;
  bool is_unix() const { return scheme == "unix"; }

  /// Throws Error(invalid_argument) for what has not that form.
  static Place parse(const std::string& address);
  /// Throws Error(input_output) for a host that is not known.
  std::vector<boost::asio::ip::tcp::endpoint> resolve() const;
};

/// Throws Error(not_supported) if that address is beyond this machine.
void require_loopback(const boost::asio::ip::tcp::endpoint& endpoint, const std::string& address);

}  // namespace tandem::tcp
