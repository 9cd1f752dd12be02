// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "address.hpp"

#include "tandem/error.hpp"

namespace tandem::tcp {
namespace {

using Tcp = boost::asio::ip::tcp;

[[noreturn]] void refuse(const std::string& address) {
  throw Error(ErrorCode::invalid_argument,
              "address '" + address + "' is not of the form tcp://HOST:PORT, tls://HOST:PORT or unix:PATH");
}

}  // namespace

Place Place::parse(const std::string& address) {
  if (address.starts_with("unix:") && address.size() > 5) return {"unix", "", "", address.substr(5)};
  const auto slashes = address.find("://");
  const std::string scheme = address.substr(0, slashes);
  if (slashes == std::string::npos || (scheme != "tcp" && scheme != "tls")) refuse(address);
  std::string host = address.substr(slashes + 3);
  const auto colon = host.rfind(':');
  if (colon == std::string::npos || colon == 0) refuse(address);
  const std::string port = host.substr(colon + 1);
  host.resize(colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (host == "*")
    throw Error(ErrorCode::invalid_argument,
                "address '" + address +
                    "' has the host '*'; allowed is a name or a number, which is "
                    "0.0.0.0 or [::] to listen at every interface");
  const bool number = !port.empty() && port.size() <= 5 &&
                      port.find_first_not_of("0123456789") == std::string::npos && std::stoi(port) < 65536;
  if (!number) refuse(address);
  return {scheme, host, port, ""};
}

std::vector<Tcp::endpoint> Place::resolve() const {
  boost::system::error_code code;
  Tcp::resolver resolver(context());
  std::vector<Tcp::endpoint> all;
  for (const auto& entry : resolver.resolve(host, port, code)) all.push_back(entry.endpoint());
  if (code || all.empty())
    throw Error(ErrorCode::input_output, "host '" + host + "' is not known");
  return all;
}

void require_loopback(const Tcp::endpoint& endpoint, const std::string& address) {
  if (!endpoint.address().is_loopback())
    throw Error(ErrorCode::not_supported,
                "address '" + address + "' is beyond this machine (" + endpoint.address().to_string() +
                    "), and tcp is plain text; allowed is tls:// or zmq with keys, or say --allow-plaintext");
}

}  // namespace tandem::tcp
