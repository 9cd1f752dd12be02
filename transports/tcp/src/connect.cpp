// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <sys/socket.h>

#include <boost/asio/local/stream_protocol.hpp>
#include <cerrno>
#include <cstring>
#include <thread>

#include "address.hpp"
#include "descriptors.hpp"
#include "tandem/error.hpp"
#include "tandem/tcp/tcp.hpp"
#include "tls.hpp"

namespace tandem {
namespace tcp {
namespace {

namespace asio = boost::asio;

/// Connected by then, or the number of the error.
int attempt(Socket& socket, const Endpoint& endpoint, wire::Deadline deadline) {
  socket.native_non_blocking(true);
  const int handle = socket.native_handle();
  while (::connect(handle, endpoint.data(), static_cast<socklen_t>(endpoint.size())) != 0) {
    if (errno == EISCONN) break;
    if (errno == EAGAIN) {  // a Unix socket whose queue is full
      if (std::chrono::steady_clock::now() > deadline) return ETIMEDOUT;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      continue;
    }
    if (errno != EINPROGRESS && errno != EINTR) return errno;
    if (!wait_for(handle, POLLOUT, deadline)) return ETIMEDOUT;
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(handle, SOL_SOCKET, SO_ERROR, &error, &size);
    return error;
  }
  return 0;
}

std::vector<Endpoint> endpoints(const Place& place, const std::string& address, bool allow_plaintext) {
  if (place.is_unix()) {
    if (place.path.size() > 107)
      throw Error(ErrorCode::invalid_argument, "path '" + place.path + "' has " +
                                                   std::to_string(place.path.size()) +
                                                   " bytes; a Unix socket's may have up to 107");
    return {asio::local::stream_protocol::endpoint(place.path)};
  }
  std::vector<Endpoint> all;
  for (const auto& endpoint : place.resolve()) {
    if (!allow_plaintext && place.scheme == "tcp") require_loopback(endpoint, address);
    all.emplace_back(endpoint);
  }
  return all;
}

Socket connected(const std::string& address, const SocketSettings& settings, wire::Deadline deadline) {
  const Place place = Place::parse(address);
  int error = 0;
  for (const Endpoint& endpoint : endpoints(place, address, settings.allow_plaintext)) {
    Socket socket = open_socket(endpoint.protocol());
    error = attempt(socket, endpoint, deadline);
    if (error != 0) continue;
    socket.native_non_blocking(false);
    if (!place.is_unix()) socket.set_option(asio::ip::tcp::no_delay(true));
    return socket;
  }
  throw Error(ErrorCode::input_output, error == ETIMEDOUT
                                           ? "no connection to " + address + " within the deadline"
                                           : "no connection to " + address + ": " + std::strerror(error));
}

}  // namespace
}  // namespace tcp

std::unique_ptr<wire::Channel> connect(const std::string& address, const SocketSettings& settings) {
  const auto deadline = wire::in_seconds(settings.deadline);
  const auto secure = tcp::securing(address, settings.tls, tcp::Side::client);
  auto stream =
      std::make_unique<tcp::SocketStream>(tcp::connected(address, settings, deadline), settings.spin);
  return std::make_unique<tcp::StreamChannel>(secure(std::move(stream), deadline), address);
}

std::unique_ptr<wire::Channel> adopt(int socket, const std::string& peer, const SocketSettings& settings) {
  tcp::Socket adopted =
      tcp::socket_of(tcp::Descriptor(socket), boost::asio::generic::stream_protocol(AF_UNIX, 0));
  adopted.native_non_blocking(false);
  auto stream = std::make_unique<tcp::SocketStream>(std::move(adopted), settings.spin);
  return std::make_unique<tcp::StreamChannel>(std::move(stream), peer);
}

}  // namespace tandem
