// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "descriptors.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tandem/error.hpp"

namespace tandem::tcp {
namespace {

/// Where the system can't do it in the same call, a program that another thread starts meanwhile inherits it.
[[maybe_unused]] int closed_in_programs(int descriptor) noexcept {
  if (descriptor >= 0) ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  return descriptor;
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

Socket socket_of(Descriptor descriptor, const boost::asio::generic::stream_protocol& protocol) {
  Socket socket(context(), protocol, descriptor.get());
  descriptor.release();
  return socket;
}

Socket open_socket(const boost::asio::generic::stream_protocol& protocol) {
#ifdef SOCK_CLOEXEC
  Descriptor descriptor(::socket(protocol.family(), protocol.type() | SOCK_CLOEXEC, protocol.protocol()));
#else
  Descriptor descriptor(
      closed_in_programs(::socket(protocol.family(), protocol.type(), protocol.protocol())));
#endif
  if (descriptor.get() < 0)
    throw Error(ErrorCode::input_output, std::string("no socket: ") + std::strerror(errno));
  return socket_of(std::move(descriptor), protocol);
}

Descriptor accept_connection(int listening) noexcept {
#ifdef SOCK_CLOEXEC
  return Descriptor(::accept4(listening, nullptr, nullptr, SOCK_CLOEXEC));
#else
  return Descriptor(closed_in_programs(::accept(listening, nullptr, nullptr)));
#endif
}

}  // namespace tandem::tcp
