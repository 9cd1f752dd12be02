// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem {

/// Whether this build has TLS.
bool has_tls() noexcept;

/// A secret key and its certificate, in PEM.
struct Certified {
  std::string key, certificate;
};

/// What two machines need for TLS: an authority's certificate, and of each side one that it has signed.
struct TlsPair {
  std::string authority;
  Certified server, client;
};

/// Makes new ones (Ed25519), valid from an hour ago, as clocks differ, for `seconds` from now. The
/// authority's own key is forgotten: it signs these two and no more. Throws Error(not_supported) in a build
/// without TLS.
TlsPair make_tls_pair(double seconds);

}  // namespace tandem
