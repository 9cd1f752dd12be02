// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <cerrno>
#include <cstring>
#include <utility>

#include "address.hpp"
#include "descriptors.hpp"
#include "tandem/error.hpp"
#include "tandem/tcp/tcp.hpp"
#include "tandem/transports/socket_file.hpp"
#include "tls.hpp"

namespace tandem {
namespace tcp {
namespace {

namespace asio = boost::asio;
using Acceptor = asio::basic_socket_acceptor<asio::generic::stream_protocol>;

/// A file that is left of a server which is gone. One with a full queue is not, and is not waited for.
bool stale(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISSOCK(status.st_mode)) return false;
  const Endpoint place = asio::local::stream_protocol::endpoint(path);
  Socket probe = open_socket(place.protocol());
  probe.native_non_blocking(true);
  return ::connect(probe.native_handle(), place.data(), static_cast<socklen_t>(place.size())) != 0 &&
         errno == ECONNREFUSED;
}

Endpoint endpoint_of(const Place& place, const std::string& address, bool allow_plaintext) {
  if (place.is_unix()) {
    if (stale(place.path)) ::unlink(place.path.c_str());
    if (std::error_code failed; std::filesystem::exists(place.path, failed))
      throw Error(ErrorCode::input_output,
                  "no listening at " + address +
                      ": something is there; allowed are a path where there is nothing, and a socket whose "
                      "server is gone");
    return asio::local::stream_protocol::endpoint(place.path);
  }
  const auto all = place.resolve();
  if (!allow_plaintext && place.scheme == "tcp")
    for (const auto& endpoint : all) require_loopback(endpoint, address);
  return all.front();
}

class SocketListener final : public wire::Listener {
 public:
  SocketListener(const std::string& address, const SocketSettings& settings)
      : place_(Place::parse(address)),
        settings_(settings),
        secure_(securing(address, settings.tls, Side::server)),
        acceptor_(context()),
        address_(address) {
    try {
      open(endpoint_of(place_, address, settings.allow_plaintext));
    } catch (const boost::system::system_error& error) {
      throw Error(ErrorCode::input_output, "no listening at " + address + ": " + error.code().message());
    }
  }

  std::unique_ptr<wire::Channel> accept(wire::Deadline deadline) override {
    if (!wait_for(acceptor_.native_handle(), POLLIN, deadline, true)) return nullptr;
    Descriptor connection = accept_connection(acceptor_.native_handle());
    if (connection.get() < 0) return no_connection(errno);
    boost::system::error_code code;
    Socket socket = socket_of(std::move(connection), protocol_);
    if (!place_.is_unix()) socket.set_option(asio::ip::tcp::no_delay(true), code);
    const std::string peer = place_.is_unix() ? address_ : name_of(socket);
    auto stream = std::make_unique<SocketStream>(std::move(socket), settings_.spin);
    return std::make_unique<StreamChannel>(secure_(std::move(stream), wire::in_seconds(settings_.deadline)),
                                           peer);
  }
  const std::string& address() const override { return address_; }

 private:
  /// One that went again before it was taken is none.
  static std::unique_ptr<wire::Channel> no_connection(int error) {
    if (error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM)
      throw Error(ErrorCode::input_output, std::strerror(error));
    return nullptr;
  }

  void open(const Endpoint& endpoint) {
    protocol_ = endpoint.protocol();
    acceptor_.assign(protocol_, open_socket(protocol_).release());
    if (place_.is_unix())
      ::fchmod(acceptor_.native_handle(), S_IRUSR | S_IWUSR);  // before there is a file to connect to
    else
      acceptor_.set_option(Acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
    if (place_.is_unix()) {
      file_ = SocketFile(place_.path);
      return;
    }
    const auto bound = tcp_endpoint(acceptor_.local_endpoint());
    address_ = place_.scheme + "://" + (bound.address().is_v6() ? "[" + place_.host + "]" : place_.host) +
               ":" + std::to_string(bound.port());
  }

  static asio::ip::tcp::endpoint tcp_endpoint(const Endpoint& endpoint) {
    asio::ip::tcp::endpoint e;
    e.resize(endpoint.size());
    std::memcpy(e.data(), endpoint.data(), endpoint.size());
    return e;
  }
  static std::string name_of(const Socket& socket) {
    boost::system::error_code code;
    const auto endpoint = tcp_endpoint(socket.remote_endpoint(code));
    return code ? "a peer that is gone"
                : endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
  }

  Place place_;
  SocketSettings settings_;
  Secure secure_;
  asio::generic::stream_protocol protocol_{0, 0};
  Acceptor acceptor_;
  SocketFile file_;
  std::string address_;
};

}  // namespace
}  // namespace tcp

std::unique_ptr<wire::Listener> listen(const std::string& address, const SocketSettings& settings) {
  return std::make_unique<tcp::SocketListener>(address, settings);
}

}  // namespace tandem
