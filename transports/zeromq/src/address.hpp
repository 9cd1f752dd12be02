// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/zeromq/zeromq.hpp"

namespace tandem::zeromq {

/// What ZeroMQ is to open for "tcp://HOST:PORT", "ipc://PATH" or "inproc://NAME". Without keys or leave to
/// use plain text the host of tcp becomes the number of a loopback interface, as ZeroMQ would look a name up
/// again, and reads other things there too (an interface; "FROM;TO"). Throws Error: invalid_argument for what
/// has not that form, input_output for a host that is not known, not_supported for one that is beyond this
/// machine by any of its numbers.
std::string to_open(const std::string& address, const ZmqSettings& settings);

/// The address of a session's own socket, beside that of the listener: any port, or the path with a number.
std::string beside(const std::string& address, unsigned number);
/// The same as a client sees it, whose name of the host or the path may be another one than the server's.
/// `answer`: what the server says. Throws Error(invalid_argument) if that ends in no number.
std::string beside(const std::string& address, const std::string& answer);

}  // namespace tandem::zeromq
