// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tls_context.hpp"

#include <openssl/pem.h>

#include <vector>

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

/// Those of a file, which is read here and not by OpenSSL: it would wait at a FIFO.
std::vector<TlsOwned<X509>> read_certificates(const std::filesystem::path& file) {
  const std::string text = read_key_file(file, false, "certificate file");
  const TlsOwned<BIO> bytes(::BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  std::vector<TlsOwned<X509>> all;
  ::ERR_clear_error();
  while (X509* one = ::PEM_read_bio_X509_AUX(bytes.get(), nullptr, no_pass_phrase, nullptr))
    all.emplace_back(one);
  const bool at_end = ERR_GET_REASON(::ERR_peek_last_error()) == PEM_R_NO_START_LINE;
  if (all.empty() || !at_end) refuse_file("certificate", file, "can't be used: " + tls_reason());
  ::ERR_clear_error();
  return all;
}

/// The first certificate of the file, and those that lead from it to the authority.
void show_certificate(SSL_CTX* context, const std::filesystem::path& key_file) {
  std::filesystem::path file = key_file;
  file.replace_extension(".crt");
  const TlsOwned<EVP_PKEY> key = read_key(key_file);
  const auto chain = read_certificates(file);
  bool used = ::SSL_CTX_use_certificate(context, chain[0].get()) == 1;
  for (std::size_t k = 1; k < chain.size(); ++k)
    used = used && ::SSL_CTX_add1_chain_cert(context, chain[k].get()) == 1;
  if (!used) refuse_file("certificate", file, "can't be used: " + tls_reason());
  if (::SSL_CTX_use_PrivateKey(context, key.get()) != 1)
    refuse_file("key", key_file, "is not that of the certificate '" + file.string() + "': " + tls_reason());
}

void trust(SSL_CTX* context, const std::filesystem::path& authority) {
  for (const TlsOwned<X509>& one : read_certificates(authority))
    if (::X509_STORE_add_cert(::SSL_CTX_get_cert_store(context), one.get()) != 1)
      refuse_file("certificate", authority, "can't be used: " + tls_reason());
}

}  // namespace

std::shared_ptr<SSL_CTX> tls_context(const TlsFiles& files, Side side) {
  begin_tls();
  TlsOwned<SSL_CTX> context(
      ::SSL_CTX_new(side == Side::client ? ::TLS_client_method() : ::TLS_server_method()));
  if (!context || ::SSL_CTX_set_min_proto_version(context.get(), TLS1_3_VERSION) != 1)
    throw Error(ErrorCode::not_supported, "this OpenSSL has no TLS 1.3: " + tls_reason());
  ::SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, nullptr);
  ::SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  ::SSL_CTX_set_num_tickets(context.get(), 0);
  ::SSL_CTX_set_read_ahead(context.get(), 1);  // header and body of a record by one call to the system
  show_certificate(context.get(), files.key);
  trust(context.get(), files.authority);
  return context;
}

}  // namespace tandem::tcp
