// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "socket_stream.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "tandem/error.hpp"

namespace tandem::tcp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_to(wire::Deadline deadline) {
  return deadline == wire::Deadline::max() ? 1e9
                                           : std::chrono::duration<double>(deadline - Clock::now()).count();
}

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

[[noreturn]] void fail(const char* what) {
  throw Error(ErrorCode::input_output, std::string(what) + ": " + std::strerror(errno));
}

}  // namespace

boost::asio::io_context& context() {
  static auto* const the_context = new boost::asio::io_context;
  return *the_context;
}

bool wait_for(int socket, short events, wire::Deadline deadline, bool interruptible) {
  pollfd entry{socket, events, 0};
  for (double left; (left = seconds_to(deadline)) > 0.0;) {
    const int ready = ::poll(&entry, 1, static_cast<int>(std::ceil(std::min(left, 1e6) * 1e3)));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) fail("the connection can't be waited for");
    if (ready < 0 && interruptible) return false;
  }
  return false;
}

SocketStream::~SocketStream() { ::close(descriptor_); }

/// What is there now; nothing if there is none.
std::optional<std::size_t> SocketStream::receive(std::span<std::byte> to, int flags) {
  const ssize_t count = ::recv(descriptor_, to.data(), to.size(), flags);
  if (count >= 0) return static_cast<std::size_t>(count);
  if (!would_block()) fail("the connection broke");
  return std::nullopt;
}

/// The system's own limit for a blocking read: one call instead of a look, a poll and a read. It is told
/// again only if it has to change by more than a hundredth.
void SocketStream::set_timeout(wire::Deadline deadline) {
  const double left = std::max(seconds_to(deadline), 1e-3);
  if (std::abs(left - timeout_) < 0.01 * left) return;
  timeval time{};
  time.tv_sec = static_cast<time_t>(left);
  time.tv_usec = static_cast<suseconds_t>((left - std::floor(left)) * 1e6);
  if (::setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time) != 0)
    fail("a deadline can't be set");
  timeout_ = left;
}

std::optional<std::size_t> SocketStream::read(std::span<std::byte> to, wire::Deadline deadline) {
  if (spin_ > 0.0)
    for (const auto end = std::min(wire::in_seconds(spin_), deadline); Clock::now() < end;)
      if (const auto count = receive(to, MSG_DONTWAIT)) return count;
  while (seconds_to(deadline) > 0.0) {
    set_timeout(deadline);
    if (const auto count = receive(to, 0)) return count;
  }
  return std::nullopt;
}

void SocketStream::write(std::span<const std::byte> bytes, wire::Deadline deadline) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0)
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    else if (!would_block())
      fail("the connection broke");
    else if (!wait_for(descriptor_, POLLOUT, deadline))
      throw Error(ErrorCode::input_output, "the peer took no data within the deadline");
  }
}

void SocketStream::shut_down() noexcept { ::shutdown(descriptor_, SHUT_RDWR); }

}  // namespace tandem::tcp
