// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// In place of the other sources of TLS in a build without OpenSSL.
#include "tandem/error.hpp"
#include "tandem/tcp/certificates.hpp"
#include "tls.hpp"

namespace tandem {

tcp::Secure tcp::tls(const std::string& address, const TlsFiles&, Side) {
  throw Error(ErrorCode::not_supported,
              "address '" + address + "' needs TLS, which this build has not (package libssl-dev)");
}

bool has_tls() noexcept { return false; }

TlsPair make_tls_pair(double) {
  throw Error(ErrorCode::not_supported,
              "certificates need OpenSSL, which this build has not (package libssl-dev)");
}

}  // namespace tandem
