// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/transports.hpp"

#include "tandem/error.hpp"
#if TANDEM_HAS_ZEROMQ
#include "tandem/zeromq/zeromq.hpp"
#endif

namespace tandem::cli {
namespace {

std::unique_ptr<wire::Listener> at_zeromq([[maybe_unused]] const std::string& address,
                                          [[maybe_unused]] const SocketSettings& socket,
                                          [[maybe_unused]] const ServerKeys& keys) {
#if TANDEM_HAS_ZEROMQ
  ZmqSettings settings{socket.deadline, socket.allow_plaintext, {}, {}, {}};
  if (!keys.own.empty())
    settings.keys = {read_curve_key(keys.own + ".pub", false), read_curve_key(keys.own, true)};
  for (const std::string& file : keys.clients) settings.clients.push_back(read_curve_key(file, false));
  return zmq_listen(address, settings);
#else
  throw Error(ErrorCode::not_supported, "this build has no ZeroMQ (packages cppzmq-dev, libzmq3-dev)");
#endif
}

}  // namespace

std::unique_ptr<wire::Listener> listener_at(const std::string& address, const SocketSettings& settings,
                                            const ServerKeys& keys) {
  if (address.find('?') != std::string::npos)
    throw Error(ErrorCode::invalid_argument, "address '" + address +
                                                 "' has a '?': parameters follow it in a client's; a server "
                                                 "has options in their place (--deadline, "
                                                 "--spin, --key, ...)");
  const std::string scheme = address.substr(0, address.find(':'));
  const bool zmq = scheme == "zmq", tls = scheme == "tls";
  if (!zmq && !tls && scheme != "tcp" && scheme != "unix")
    throw Error(ErrorCode::invalid_argument,
                "nothing can listen at '" + address +
                    "'; allowed are tcp://HOST:PORT, tls://HOST:PORT, unix:PATH and zmq:ADDRESS");
  if ((!keys.own.empty() && !zmq && !tls) || (!keys.clients.empty() && !zmq) ||
      (!keys.authority.empty() && !tls))
    throw Error(ErrorCode::invalid_argument,
                "these keys are of no use at " + address +
                    "; allowed are --key and --authority at tls://HOST:PORT, --key and --client-key at "
                    "zmq:ADDRESS");
  if (zmq) return at_zeromq(address.substr(4), settings, keys);
  SocketSettings secured = settings;
  secured.tls = {keys.own, keys.authority};
  return listen(address, secured);
}

}  // namespace tandem::cli
