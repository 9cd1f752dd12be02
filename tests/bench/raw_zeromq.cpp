// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#if TANDEM_HAS_ZEROMQ
#include <zmq.h>

#include <array>
#include <thread>
#include <vector>

#include "bench/in_turns.hpp"
#include "bench/raw_link.hpp"
#include "tandem/error.hpp"
#include "tandem/zeromq/zeromq.hpp"

namespace tandem::bench {
namespace {

void zmq_sound(int result, const char* what) {
  if (result < 0)
    throw Error(ErrorCode::input_output,
                std::string("bench transports: ") + what + ": " + ::zmq_strerror(::zmq_errno()));
}

struct FreeZmq {
  void operator()(void* socket) const noexcept { ::zmq_close(socket); }
};
struct EndZmq {
  void operator()(void* context) const noexcept { ::zmq_ctx_term(context); }
};
using ZmqSocket = std::unique_ptr<void, FreeZmq>;

void set_key(const ZmqSocket& socket, int option, const std::string& key) {
  zmq_sound(::zmq_setsockopt(socket.get(), option, key.data(), key.size()), "a key");
}

void secure_ends(const ZmqSocket& here, const ZmqSocket& there) {
  const CurveKeys client = make_curve_keys(), server = make_curve_keys();
  const int one = 1;
  zmq_sound(::zmq_setsockopt(there.get(), ZMQ_CURVE_SERVER, &one, sizeof one), "CURVE");
  set_key(there, ZMQ_CURVE_SECRETKEY, server.secret_key);
  set_key(here, ZMQ_CURVE_SERVERKEY, server.public_key);
  set_key(here, ZMQ_CURVE_PUBLICKEY, client.public_key);
  set_key(here, ZMQ_CURVE_SECRETKEY, client.secret_key);
}

/// Bytes of the next message.
int receive(const ZmqSocket& socket, std::vector<std::byte>& to) {
  return ::zmq_recv(socket.get(), to.data(), to.size(), 0);
}

class RawZeroMq final : public RawLink {
 public:
  RawZeroMq(const std::string& address, const Sizes& sizes, bool curve)
      : request_(sizes.request), reply_(sizes.reply) {
    if (curve) secure_ends(here_, there_);
    zmq_sound(::zmq_bind(there_.get(), address.c_str()), "bind");
    std::array<char, 256> place{};
    std::size_t size = place.size();
    zmq_sound(::zmq_getsockopt(there_.get(), ZMQ_LAST_ENDPOINT, place.data(), &size), "address");
    zmq_sound(::zmq_connect(here_.get(), place.data()), "connect");
    thread_ = std::thread([this, sizes] { answer_all(sizes); });
  }
  /// The other end stops at a message without bytes.
  ~RawZeroMq() override {
    ::zmq_send(here_.get(), nullptr, 0, 0);
    thread_.join();
  }
  RawZeroMq(const RawZeroMq&) = delete;
  RawZeroMq& operator=(const RawZeroMq&) = delete;

  void exchange() override {
    zmq_sound(::zmq_send(here_.get(), request_.data(), request_.size(), 0), "send");
    zmq_sound(receive(here_, reply_), "receive");
  }

 private:
  void answer_all(const Sizes& sizes) {
    pin(places().there);
    std::vector<std::byte> request(sizes.request), reply(sizes.reply);
    while (receive(there_, request) > 0) ::zmq_send(there_.get(), reply.data(), reply.size(), 0);
  }

  std::unique_ptr<void, EndZmq> context_{::zmq_ctx_new()};
  ZmqSocket here_{::zmq_socket(context_.get(), ZMQ_DEALER)}, there_{::zmq_socket(context_.get(), ZMQ_DEALER)};
  std::vector<std::byte> request_, reply_;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<RawLink> raw_zeromq(const std::string& address, const Sizes& sizes, bool curve) {
  return std::make_unique<RawZeroMq>(address, sizes, curve);
}

}  // namespace tandem::bench
#endif
