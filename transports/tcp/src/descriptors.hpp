// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "socket_stream.hpp"

namespace tandem::tcp {

/// A new socket that programs which are started don't inherit. Throws Error(input_output).
Socket open_socket(const boost::asio::generic::stream_protocol& protocol);

/// The next connection of a listening socket, which is not inherited either. -1, with errno, if there is
/// none.
int accept_connection(int listening) noexcept;

}  // namespace tandem::tcp
