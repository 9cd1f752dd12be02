// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "socket.hpp"
#include "tandem/transports/socket_file.hpp"

namespace tandem::zeromq {

/// Whether something is at "ipc://PATH" that must not be replaced: any file but a socket whose server is
/// gone. False for addresses that are no path.
bool taken(const std::string& address);

/// Has a socket listen at an address as bind_to() does, and gives the file of "ipc://PATH"; none of an
/// address that is no path. ZeroMQ is given the system's socket: by itself it would replace whatever is
/// there, and remove, when it closes, whatever is there by then. Precondition: not taken(). Throws
/// zmq::error_t.
SocketFile bind_with_file(zmq::socket_t& socket, const std::string& address);

}  // namespace tandem::zeromq
