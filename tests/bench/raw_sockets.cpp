// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "bench/in_turns.hpp"
#include "bench/raw_link.hpp"
#include "tandem/error.hpp"

namespace tandem::bench {
namespace {

int sound(int result, const char* what) {
  if (result < 0)
    throw Error(ErrorCode::input_output,
                std::string("bench transports: ") + what + ": " + std::strerror(errno));
  return result;
}

/// An end that closes itself.
class End {
 public:
  explicit End(int descriptor) : descriptor_(descriptor) {}
  End(End&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  End& operator=(End&&) = delete;
  ~End() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int get() const { return descriptor_; }

  bool send_all(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
  }
  bool receive_all(std::span<std::byte> bytes, bool spins) const {
    while (!bytes.empty()) {
      const ssize_t count =
          spins ? receive_spinning(bytes) : ::recv(descriptor_, bytes.data(), bytes.size(), 0);
      if (count <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
  }

 private:
  /// After a millisecond without bytes it waits: the turn is another's.
  ssize_t receive_spinning(std::span<std::byte> bytes) const {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::milliseconds(1); Clock::now() < end;) {
      const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (count >= 0 || (errno != EAGAIN && errno != EWOULDBLOCK)) return count;
    }
    return ::recv(descriptor_, bytes.data(), bytes.size(), 0);
  }

  int descriptor_;
};

std::pair<End, End> tcp_ends() {
  const End listener(sound(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), "socket"));
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* address = reinterpret_cast<sockaddr*>(&place);
  socklen_t size = sizeof place;
  sound(::bind(listener.get(), address, size), "bind");
  sound(::listen(listener.get(), 1), "listen");
  sound(::getsockname(listener.get(), address, &size), "getsockname");
  End here(sound(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), "socket"));
  sound(::connect(here.get(), address, size), "connect");
  End there(sound(::accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC), "accept"));
  const int one = 1;
  for (const int end : {here.get(), there.get()})
    sound(::setsockopt(end, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one), "TCP_NODELAY");
  return {std::move(here), std::move(there)};
}

std::pair<End, End> unix_ends() {
  int ends[2];
  sound(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), "socketpair");
  return {End(ends[0]), End(ends[1])};
}

class RawSockets final : public RawLink {
 public:
  RawSockets(std::pair<End, End> ends, const Sizes& sizes, bool spins)
      : here_(std::move(ends.first)),
        there_(std::move(ends.second)),
        spins_(spins),
        request_(sizes.request),
        reply_(sizes.reply),
        thread_([this, sizes] { answer_all(sizes); }) {}
  ~RawSockets() override {
    ::shutdown(here_.get(), SHUT_RDWR);
    thread_.join();
  }
  RawSockets(const RawSockets&) = delete;
  RawSockets& operator=(const RawSockets&) = delete;

  void exchange() override {
    if (!here_.send_all(request_) || !here_.receive_all(reply_, spins_))
      throw Error(ErrorCode::input_output, "bench transports: the raw sockets broke");
  }

 private:
  void answer_all(const Sizes& sizes) {
    pin(places().there);
    std::vector<std::byte> request(sizes.request), reply(sizes.reply);
    while (there_.receive_all(request, spins_) && there_.send_all(reply)) {
    }
  }

  End here_, there_;
  bool spins_;
  std::vector<std::byte> request_, reply_;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<RawLink> raw_sockets(const std::string& transport, const Sizes& sizes, bool spins) {
  return std::make_unique<RawSockets>(transport == "unix" ? unix_ends() : tcp_ends(), sizes, spins);
}

}  // namespace tandem::bench
