// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tls_context.hpp"

#include <openssl/pem.h>

#include "tandem/error.hpp"
#include "tandem/transports/key_file.hpp"

namespace tandem::tcp {
namespace {

/// A key under a pass phrase is refused; OpenSSL would ask the terminal for it.
int no_pass_phrase(char*, int, int, void*) { return -1; }

[[noreturn]] void refuse_file(const std::string& what, const std::filesystem::path& file,
                              const std::string& why) {
  throw Error(ErrorCode::input_output, what + " file '" + file.string() + "' " + why);
}

TlsOwned<EVP_PKEY> read_key(const std::filesystem::path& file) {
  const std::string text = read_key_file(file, true);
  const TlsOwned<BIO> bytes(::BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  TlsOwned<EVP_PKEY> key(::PEM_read_bio_PrivateKey(bytes.get(), nullptr, no_pass_phrase, nullptr));
  ::ERR_clear_error();
  if (!key) refuse_file("key", file, "holds no private key; allowed is one in PEM without a pass phrase");
  return key;
}

void show_certificate(SSL_CTX* context, const std::filesystem::path& key_file) {
  std::filesystem::path file = key_file;
  file.replace_extension(".crt");
  const TlsOwned<EVP_PKEY> key = read_key(key_file);
  if (::SSL_CTX_use_certificate_chain_file(context, file.c_str()) != 1)
    refuse_file("certificate", file, "can't be used: " + tls_reason());
  if (::SSL_CTX_use_PrivateKey(context, key.get()) != 1)
    refuse_file("key", key_file, "is not that of the certificate '" + file.string() + "': " + tls_reason());
}

}  // namespace

std::shared_ptr<SSL_CTX> tls_context(const TlsFiles& files, Side side) {
  TlsOwned<SSL_CTX> context(
      ::SSL_CTX_new(side == Side::client ? ::TLS_client_method() : ::TLS_server_method()));
  if (!context || ::SSL_CTX_set_min_proto_version(context.get(), TLS1_3_VERSION) != 1)
    throw Error(ErrorCode::not_supported, "this OpenSSL has no TLS 1.3: " + tls_reason());
  ::SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  ::SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  ::SSL_CTX_set_num_tickets(context.get(), 0);
  ::SSL_CTX_set_read_ahead(context.get(), 1);  // header and body of a record by one call to the system
  show_certificate(context.get(), files.key);
  if (::SSL_CTX_load_verify_file(context.get(), files.authority.c_str()) != 1)
    refuse_file("certificate", files.authority, "can't be used: " + tls_reason());
  return context;
}

}  // namespace tandem::tcp
