// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <openssl/bio.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include <cstring>
#include <memory>
#include <string>

namespace tandem::tcp {

/// Gives OpenSSL its things back.
struct TlsFree {
  void operator()(BIGNUM* p) const noexcept { ::BN_free(p); }
  void operator()(BIO* p) const noexcept { ::BIO_free(p); }
  void operator()(BIO_METHOD* p) const noexcept { ::BIO_meth_free(p); }
  void operator()(EVP_PKEY* p) const noexcept { ::EVP_PKEY_free(p); }
  void operator()(SSL* p) const noexcept { ::SSL_free(p); }
  void operator()(SSL_CTX* p) const noexcept { ::SSL_CTX_free(p); }
  void operator()(X509* p) const noexcept { ::X509_free(p); }
  void operator()(X509_EXTENSION* p) const noexcept { ::X509_EXTENSION_free(p); }
};
template <class T>
using TlsOwned = std::unique_ptr<T, TlsFree>;

/// Before any other call. OpenSSL would clean up at the program's exit, beneath connections that static
/// objects close after that.
inline void begin_tls() { ::OPENSSL_init_ssl(OPENSSL_INIT_NO_ATEXIT, nullptr); }

/// Why a call failed, as OpenSSL says it first; forgets it.
inline std::string tls_reason() {
  const unsigned long error = ::ERR_peek_error();
  ::ERR_clear_error();
  if (ERR_SYSTEM_ERROR(error)) return std::strerror(ERR_GET_REASON(error));
  const char* text = ::ERR_reason_error_string(error);
  return text ? text : "no reason given";
}

}  // namespace tandem::tcp
