// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <zmq.hpp>

#include "tandem/zeromq/zeromq.hpp"

namespace tandem::zeromq {

/// The one of this process, so that inproc:// addresses meet. It is never taken down: a socket that somebody
/// still holds would keep the program from its end.
zmq::context_t& context();

/// Throws Error(input_output) with the address.
[[noreturn]] void fail(const std::string& what, const std::string& address, const zmq::error_t& error);

/// Sets keys, and limits of time and memory; before bind or connect. domain: of a server's socket, that the
/// Gate knows it by; of a client's there is none.
void secure(zmq::socket_t& socket, const ZmqSettings& settings, const std::string& domain = "");
/// A peer that sends a longer part of a message is cut off; before bind or connect.
void limit_messages(zmq::socket_t& socket, std::uint64_t bytes);
/// At what to_open() gives; IPv6 where that is a number of it.
void bind_to(zmq::socket_t& socket, const std::string& place);
void connect_to(zmq::socket_t& socket, const std::string& place);

/// Waits up to so many milliseconds; a signal ends the wait too.
bool readable(zmq::socket_t& socket, int milliseconds);

}  // namespace tandem::zeromq
