// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <cmath>

#include "tandem/error.hpp"
#include "tandem/tcp/certificates.hpp"
#include "tls_owned.hpp"

namespace tandem {
namespace tcp {
namespace {

void require(bool done) {
  if (!done) throw Error(ErrorCode::internal, "a certificate can't be made: " + tls_reason());
}

/// A certificate with the key that it is about.
struct Signed {
  TlsOwned<X509> certificate;
  TlsOwned<EVP_PKEY> key;
};

/// Extensions of RFC 5280, section 4.2.1, in the words of openssl's x509v3_config.
struct Use {
  const char *name, *constraints, *key_usage, *extended;
};
constexpr Use authority_use{"tandem authority", "critical,CA:TRUE,pathlen:0", "critical,keyCertSign",
                            nullptr};
constexpr Use server_use{"tandem server", "critical,CA:FALSE", "critical,digitalSignature", "serverAuth"};
constexpr Use client_use{"tandem client", "critical,CA:FALSE", "critical,digitalSignature", "clientAuth"};

void add_extension(X509* certificate, X509* issuer, int kind, const char* value) {
  X509V3_CTX context{};
  ::X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  const TlsOwned<X509_EXTENSION> extension(::X509V3_EXT_conf_nid(nullptr, &context, kind, value));
  require(extension && ::X509_add_ext(certificate, extension.get(), -1) == 1);
}

/// 127 bits at random: no two alike.
void number(X509* certificate) {
  const TlsOwned<BIGNUM> serial(::BN_new());
  require(serial && ::BN_rand(serial.get(), 127, BN_RAND_TOP_ANY, BN_RAND_BOTTOM_ANY) == 1);
  require(::BN_to_ASN1_INTEGER(serial.get(), ::X509_get_serialNumber(certificate)) != nullptr);
}

void date(X509* certificate, double seconds) {
  constexpr long before = 3600;
  require(::X509_gmtime_adj(::X509_getm_notBefore(certificate), -before) &&
          ::X509_gmtime_adj(::X509_getm_notAfter(certificate), std::lround(std::ceil(seconds))));
}

/// Signed by `issuer`; by itself if there is none.
Signed sign(const Use& use, const Signed* issuer, double seconds) {
  Signed made{TlsOwned<X509>(::X509_new()),
              TlsOwned<EVP_PKEY>(::EVP_PKEY_Q_keygen(nullptr, nullptr, "ED25519"))};
  X509* const c = made.certificate.get();
  require(c && made.key && ::X509_set_version(c, X509_VERSION_3) == 1);
  if (!issuer) issuer = &made;
  number(c);
  date(c, seconds);
  const auto* name = reinterpret_cast<const unsigned char*>(use.name);
  require(::X509_NAME_add_entry_by_txt(::X509_get_subject_name(c), "CN", MBSTRING_UTF8, name, -1, -1, 0) ==
          1);
  require(::X509_set_issuer_name(c, ::X509_get_subject_name(issuer->certificate.get())) == 1);
  require(::X509_set_pubkey(c, made.key.get()) == 1);
  X509* const by = issuer->certificate.get();
  add_extension(c, by, NID_basic_constraints, use.constraints);
  add_extension(c, by, NID_key_usage, use.key_usage);
  if (use.extended) add_extension(c, by, NID_ext_key_usage, use.extended);
  add_extension(c, by, NID_subject_key_identifier, "hash");
  add_extension(c, by, NID_authority_key_identifier, "keyid:always");
  require(::X509_sign(c, issuer->key.get(), nullptr) != 0);
  return made;
}

template <class Put>
std::string pem(const Put& put) {
  const TlsOwned<BIO> memory(::BIO_new(::BIO_s_secmem()));
  require(memory && put(memory.get()) == 1);
  char* text = nullptr;
  const long size = ::BIO_get_mem_data(memory.get(), &text);
  return {text, static_cast<std::size_t>(size)};
}

std::string text_of(const TlsOwned<X509>& certificate) {
  return pem([&](BIO* to) { return ::PEM_write_bio_X509(to, certificate.get()); });
}

Certified certified(const Signed& made) {
  return {pem([&](BIO* to) {
            return ::PEM_write_bio_PrivateKey(to, made.key.get(), nullptr, nullptr, 0, nullptr, nullptr);
          }),
          text_of(made.certificate)};
}

}  // namespace
}  // namespace tcp

bool has_tls() noexcept { return true; }

TlsPair make_tls_pair(double seconds) {
  const tcp::Signed authority = tcp::sign(tcp::authority_use, nullptr, seconds);
  return {tcp::text_of(authority.certificate),
          tcp::certified(tcp::sign(tcp::server_use, &authority, seconds)),
          tcp::certified(tcp::sign(tcp::client_use, &authority, seconds))};
}

}  // namespace tandem
