// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "stream.hpp"
#include "tandem/tcp/tcp.hpp"

namespace tandem::tcp {

enum class Side { client, server };

/// Makes of the stream of a connection one that its frames may go over; what has to be agreed on before has
/// to be by then.
using Secure = std::function<std::unique_ptr<Stream>(std::unique_ptr<Stream>, wire::Deadline)>;

/// TLS with these files. Throws Error as tandem::connect does.
Secure tls(const std::string& address, const TlsFiles& files, Side side);

/// What an address needs: tls() for "tls://HOST:PORT", nothing for others.
inline Secure securing(const std::string& address, const TlsFiles& files, Side side) {
  if (address.starts_with("tls:")) return tls(address, files, side);
  return [](std::unique_ptr<Stream> stream, wire::Deadline) { return stream; };
}

}  // namespace tandem::tcp
