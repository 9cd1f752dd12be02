// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include "tandem/error.hpp"
#include "tls_context.hpp"

namespace tandem::tcp {
namespace {

/// TLS over another stream, which keeps the deadlines: OpenSSL reads and writes it by two callbacks. Either
/// side's handshake is made by its first read or write, so that a server's is made in the session's thread.
class TlsStream final : public Stream {
 public:
  TlsStream(std::unique_ptr<Stream> plain, const std::shared_ptr<SSL_CTX>& context, Side side,
            wire::Deadline handshake);
  ~TlsStream() override;
  TlsStream(const TlsStream&) = delete;
  TlsStream& operator=(const TlsStream&) = delete;

  std::optional<std::size_t> read(std::span<std::byte> to, wire::Deadline deadline) override;
  void write(std::span<const std::byte> bytes, wire::Deadline deadline) override;
  void shut_down() noexcept override { plain_->shut_down(); }

 private:
  static BIO_METHOD* method();
  int take(BIO* bio, std::span<std::byte> to) noexcept;
  int put(std::span<const std::byte> bytes) noexcept;
  bool shake_hands(wire::Deadline deadline);
  [[noreturn]] void fail();
  void drain() noexcept;

  std::unique_ptr<Stream> plain_;
  std::shared_ptr<SSL_CTX> context_;
  TlsOwned<SSL> ssl_;
  Side side_;
  wire::Deadline handshake_;      ///< until when it has to be done
  wire::Deadline deadline_ = {};  ///< of the call under way
  std::exception_ptr failure_;    ///< of plain_, which OpenSSL can't hand on
  bool shaken_ = false, ended_ = false, broken_ = false;
};

TlsStream* stream_of(BIO* bio) { return static_cast<TlsStream*>(::BIO_get_data(bio)); }

/// Never freed, as static objects may close their connections at the very end of a program.
BIO_METHOD* TlsStream::method() {
  static BIO_METHOD* const the_method = [] {
    TlsOwned<BIO_METHOD> m(::BIO_meth_new(::BIO_get_new_index() | BIO_TYPE_SOURCE_SINK, "tandem stream"));
    ::BIO_meth_set_read(m.get(), [](BIO* bio, char* to, int size) {
      return stream_of(bio)->take(bio, std::as_writable_bytes(std::span(to, static_cast<std::size_t>(size))));
    });
    ::BIO_meth_set_write(m.get(), [](BIO* bio, const char* from, int size) {
      return stream_of(bio)->put(std::as_bytes(std::span(from, static_cast<std::size_t>(size))));
    });
    ::BIO_meth_set_ctrl(
        m.get(), [](BIO*, int command, long, void*) -> long { return command == BIO_CTRL_FLUSH ? 1 : 0; });
    return m.release();
  }();
  return the_method;
}

TlsStream::TlsStream(std::unique_ptr<Stream> plain, const std::shared_ptr<SSL_CTX>& context, Side side,
                     wire::Deadline handshake)
    : plain_(std::move(plain)),
      context_(context),
      ssl_(::SSL_new(context.get())),
      side_(side),
      handshake_(handshake) {
  BIO* bio = ssl_ ? ::BIO_new(method()) : nullptr;
  if (!bio) throw Error(ErrorCode::internal, "no memory for TLS");
  ::BIO_set_data(bio, this);
  ::BIO_set_init(bio, 1);
  ::SSL_set_bio(ssl_.get(), bio, bio);  // which owns it from now on
  if (side == Side::client)
    ::SSL_set_connect_state(ssl_.get());
  else
    ::SSL_set_accept_state(ssl_.get());
}

/// Says farewell if that can be done at once.
TlsStream::~TlsStream() {
  deadline_ = {};
  if (shaken_ && !broken_) ::SSL_shutdown(ssl_.get());
  ::ERR_clear_error();
}

int TlsStream::take(BIO* bio, std::span<std::byte> to) noexcept try {
  ::BIO_clear_retry_flags(bio);
  const auto count = plain_->read(to, deadline_);
  if (!count) ::BIO_set_retry_read(bio);
  ended_ = count && *count == 0;
  return count ? static_cast<int>(*count) : -1;
} catch (...) {
  failure_ = std::current_exception();
  return -1;
}

int TlsStream::put(std::span<const std::byte> bytes) noexcept try {
  plain_->write(bytes, deadline_);
  return static_cast<int>(bytes.size());
} catch (...) {
  failure_ = std::current_exception();
  return -1;
}

/// False: not done by then, and there is time left. Throws if there is none.
bool TlsStream::shake_hands(wire::Deadline deadline) {
  if (broken_) throw Error(ErrorCode::wrong_state, "the connection broke before");
  ::ERR_clear_error();
  if (shaken_) return true;
  deadline_ = std::min(deadline, handshake_);
  const int result = ::SSL_do_handshake(ssl_.get());
  shaken_ = result == 1;
  if (shaken_) return true;
  if (::SSL_get_error(ssl_.get(), result) != SSL_ERROR_WANT_READ) fail();
  if (deadline < handshake_) return false;
  broken_ = true;
  throw Error(ErrorCode::input_output, "the TLS handshake did not end within the deadline");
}

std::optional<std::size_t> TlsStream::read(std::span<std::byte> to, wire::Deadline deadline) {
  if (!shake_hands(deadline)) return std::nullopt;
  deadline_ = deadline;
  std::size_t count = 0;
  if (::SSL_read_ex(ssl_.get(), to.data(), to.size(), &count) == 1) return count;
  switch (::SSL_get_error(ssl_.get(), 0)) {
    case SSL_ERROR_WANT_READ:
      return std::nullopt;
    case SSL_ERROR_ZERO_RETURN:
      return 0;
    default:
      fail();
  }
}

void TlsStream::write(std::span<const std::byte> bytes, wire::Deadline deadline) {
  if (!shake_hands(deadline))
    throw Error(ErrorCode::input_output, "the TLS handshake did not end within the deadline");
  deadline_ = deadline;
  std::size_t count = 0;
  if (!bytes.empty() && ::SSL_write_ex(ssl_.get(), bytes.data(), bytes.size(), &count) != 1) fail();
}

void TlsStream::fail() {
  broken_ = true;
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  const std::string where = shaken_ ? "TLS failed: " : "the TLS handshake failed: ";
  if (ended_)
    throw Error(ErrorCode::input_output, shaken_ ? "the peer closed the connection without TLS's farewell"
                                                 : where + "the peer closed the connection");
  const long verdict = ::SSL_get_verify_result(ssl_.get());
  const std::string reason = verdict == X509_V_OK ? tls_reason()
                                                  : std::string("the peer's certificate is refused: ") +
                                                        ::X509_verify_cert_error_string(verdict);
  if (!shaken_ && side_ == Side::server && ::SSL_get_current_cipher(ssl_.get())) drain();
  throw Error(
      ErrorCode::input_output,
      where + reason + "; allowed is TLS 1.3, with certificates of the pair's authority on both sides");
}

/// Takes what a client that takes the handshake for done may have sent meanwhile: to close with that unread
/// would take from it, on its way, the word of why it is refused.
void TlsStream::drain() noexcept try {
  std::array<std::byte, 4096> unread;
  const auto end = std::min(handshake_, wire::in_seconds(1.0));
  while (plain_->read(unread, end).value_or(0) > 0) {
  }
} catch (...) {  // gone
}

}  // namespace

Secure tls(const std::string& address, const TlsFiles& files, Side side) {
  if (files.key.empty() || files.authority.empty())
    throw Error(ErrorCode::invalid_argument,
                "address '" + address + "' needs a key and an authority: of a client " + address +
                    "?key=FILE&authority=FILE, of a server --key FILE --authority FILE");
  return [context = tls_context(files, side), side](std::unique_ptr<Stream> plain, wire::Deadline handshake) {
    return std::make_unique<TlsStream>(std::move(plain), context, side, handshake);
  };
}

}  // namespace tandem::tcp
