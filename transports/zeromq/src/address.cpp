// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "address.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>

#include <array>

#include "tandem/error.hpp"

namespace tandem::zeromq {
namespace {

using Found = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

bool is_tcp(const std::string& address) { return address.starts_with("tcp://"); }

Found look_up(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* first = nullptr;
  if (const int code = ::getaddrinfo(host.c_str(), nullptr, &wanted, &first); code != 0)
    throw Error(ErrorCode::input_output, "host '" + host + "' is not known: " + ::gai_strerror(code));
  return {first, &::freeaddrinfo};
}

bool is_loopback(const sockaddr& place) {
  if (place.sa_family == AF_INET)
    return ntohl(reinterpret_cast<const sockaddr_in&>(place).sin_addr.s_addr) >> 24 == 127;
  return place.sa_family == AF_INET6 &&
         IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6&>(place).sin6_addr);
}

std::string number_of(const addrinfo& entry) {
  std::array<char, NI_MAXHOST> text{};
  ::getnameinfo(entry.ai_addr, entry.ai_addrlen, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST);
  return entry.ai_family == AF_INET6 ? "[" + std::string(text.data()) + "]" : text.data();
}

[[noreturn]] void refuse_plain(const std::string& address, const std::string& host) {
  throw Error(ErrorCode::not_supported,
              "address 'zmq:" + address + "' is beyond this machine (" + host +
                  "), and without keys it is plain text; allowed is ?key=FILE&server_key=FILE, of a server "
                  "--key and --client-key, or say --allow-plaintext");
}

/// Names that ZeroMQ reads otherwise: "@NAME" has no file, so that every user may connect; "*" is a file in a
/// new folder, which is left.
void refuse_without_file(const std::string& address) {
  if (address.starts_with("ipc://@") || address == "ipc://*")
    throw Error(ErrorCode::invalid_argument,
                "address 'zmq:" + address + "' names no file; allowed is a path, as ./@name is");
}

/// The first number of a host of which all are this machine's, one of IPv4 if there is any.
std::string loopback_number(const std::string& address, const std::string& host) {
  const bool brackets = host.starts_with('[') && host.ends_with(']');
  const Found found = look_up(brackets ? host.substr(1, host.size() - 2) : host);
  const addrinfo* best = nullptr;
  for (const addrinfo* entry = found.get(); entry; entry = entry->ai_next) {
    if (!is_loopback(*entry->ai_addr)) refuse_plain(address, number_of(*entry));
    if (!best || (best->ai_family != AF_INET && entry->ai_family == AF_INET)) best = entry;
  }
  return number_of(*best);
}

}  // namespace

std::string to_open(const std::string& address, const ZmqSettings& settings) {
  const auto name = address.find("://") + 3, colon = address.rfind(':');
  const bool sound = is_tcp(address) ? colon > name && colon + 1 < address.size()
                                     : (address.starts_with("ipc://") || address.starts_with("inproc://")) &&
                                           address.size() > name;
  if (!sound)
    throw Error(ErrorCode::invalid_argument,
                "address 'zmq:" + address +
                    "' is not of the form zmq:tcp://HOST:PORT, zmq:ipc://PATH or zmq:inproc://NAME");
  if (is_tcp(address) && address.substr(name, colon - name) == "*")
    throw Error(ErrorCode::invalid_argument,
                "address 'zmq:" + address +
                    "' has the host '*'; allowed is a name or a number, which is "
                    "0.0.0.0 or [::] to listen at every interface");
  refuse_without_file(address);
  if (!is_tcp(address) || settings.allow_plaintext || !settings.keys.secret_key.empty()) return address;
  return "tcp://" + loopback_number(address, address.substr(name, colon - name)) + address.substr(colon);
}

std::string beside(const std::string& address, unsigned number) {
  if (is_tcp(address)) return address.substr(0, address.rfind(':')) + ":*";
  return address + "-" + std::to_string(number);
}

std::string beside(const std::string& address, const std::string& answer) {
  const char mark = is_tcp(address) ? ':' : '-';
  const auto at = answer.rfind(mark);
  const std::string number = at == std::string::npos ? "" : answer.substr(at + 1);
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
    throw Error(ErrorCode::invalid_argument,
                "the server at zmq:" + address + " names '" + answer.substr(0, 200) +
                    "' as the place of the session; allowed is an address that ends in '" + mark +
                    "' and a number");
  return (is_tcp(address) ? address.substr(0, address.rfind(':')) : address) + mark + number;
}

}  // namespace tandem::zeromq
