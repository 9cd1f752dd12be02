// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tls.hpp"
#include "tls_owned.hpp"

namespace tandem::tcp {

/// TLS 1.3 and nothing older, with these files: both sides show a certificate and check the other's, also
/// that it was made for that side. Nothing is kept from one connection to the next.
std::shared_ptr<SSL_CTX> tls_context(const TlsFiles& files, Side side);

}  // namespace tandem::tcp
