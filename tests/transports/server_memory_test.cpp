// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What the largest requests take of a server's memory, beside its subsystem's own.
#include <gtest/gtest.h>

#include "curve_pair.hpp"
#include "served.hpp"
#include "server_process.hpp"
#include "tandem/wire/messages.hpp"
#include "tls_pair.hpp"

namespace tandem::test {
namespace {

using wire::Type;
using wire::Writer;

constexpr std::int64_t mebibyte = 1 << 20;

/// The requests of a session, written by hand; each with its reply.
class Requests {
 public:
  explicit Requests(std::unique_ptr<wire::Channel> channel) : channel_(std::move(channel)) {
    ask(Type::hello, [](Writer& w) { wire::put_hello(w, {}); });
    longest_ = wire::read_hello(payload_, wire::all_capabilities).longest;
  }
  /// Payload that the server takes and gives [bytes].
  std::uint64_t longest() const { return longest_; }

  /// The type of the reply.
  template <class Put>
  Type ask(Type type, const Put& put) {
    wire::begin(frame_, type, ++number_);
    put(frame_);
    wire::finish(frame_);
    channel_->send(frame_.bytes(), wire::in_seconds(60.0));
    const auto reply = channel_->receive(wire::in_seconds(60.0));
    const wire::Frame frame = wire::Frame::read(reply, wire::usual_longest);
    payload_ = frame.payload;
    return frame.header.type;
  }
  /// Of the last reply [bytes].
  std::size_t size() const { return payload_.size(); }

 private:
  std::unique_ptr<wire::Channel> channel_;
  Writer frame_;
  std::uint32_t number_ = 0;
  std::uint64_t longest_ = 0;
  std::span<const std::byte> payload_;
};

void put_zeros(Writer& frame, std::uint64_t bytes) { frame.put_bytes(std::vector<std::byte>(bytes)); }

Type initialize(Requests& session) {
  return session.ask(Type::initialize, [](Writer& w) { wire::put_initialize(w, {0.0, 1e9, 1, {0.0}}); });
}

/// An advance with an input of so many segments, and with room for as many rows as a reply takes.
Type advance(Requests& session, std::uint64_t count, int degree) {
  std::vector<Segment> segments(count);
  for (std::size_t k = 0; k < segments.size(); ++k) segments[k].end = 1e9 * static_cast<double>(k + 1);
  const Signal u(segments.data(), static_cast<std::int32_t>(count), degree);
  return session.ask(Type::advance, [&](Writer& w) {
    wire::put_advance(w, {1e9, false, wire::usual_longest}, {&u, 1});
  });
}

/// Each request at its largest, in a session for as long as it lasts, and what is larger and refused.
template <class Connect>
void ask_for_the_most(const ServerProcess& server, const Connect& connected, int saves) {
  Requests wrong(connected(server));
  const std::uint64_t most = wrong.longest();
  const auto zeros = [most](Writer& w) { put_zeros(w, most); };
  EXPECT_EQ(wrong.ask(Type::ping, zeros), Type::ping);
  EXPECT_EQ(wrong.ask(Type::initialize, zeros), Type::error);
  Requests session(connected(server));
  EXPECT_EQ(initialize(session), Type::samples);
  EXPECT_EQ(session.ask(Type::deserialize, zeros), Type::error);
  EXPECT_EQ(advance(session, most / sizeof(Segment) - 1, 5), Type::samples);
  EXPECT_GT(session.size(), most - 1000) << "the reply is as large as one may be";
  int kept = 0;
  for (int k = 0; k < saves; ++k) kept += session.ask(Type::save, [](Writer&) {}) == Type::save;
  EXPECT_EQ(kept, static_cast<int>(wire::most_states));
  EXPECT_EQ(advance(session, most / (3 * sizeof(double)) - 2, 0), Type::error) << "in memory it is larger";
}

/// The most that the server took beyond what it took for a session with small requests [MiB].
template <class Connect>
std::int64_t most_taken(const ServerProcess& server, const Connect& connected, int saves) {
  { EXPECT_EQ(initialize(*std::make_unique<Requests>(connected(server))), Type::samples); }
  const std::int64_t before = server.memory("VmHWM");
  ask_for_the_most(server, connected, saves);
  const std::int64_t taken = (server.memory("VmHWM") - before) / mebibyte;
  testing::Test::RecordProperty("mebibytes", static_cast<int>(taken));
  return taken;
}

/// Puts the longest request of that type, whose reply is the longest too.
void put_longest(Writer& frame, Type type, std::uint64_t most) {
  if (type == Type::ping) return put_zeros(frame, most);
  const std::vector<Segment> segments(most / sizeof(Segment) - 1, Segment{1e9, 0.0, {}});
  const Signal u(segments.data(), static_cast<std::int32_t>(segments.size()), 5);
  wire::put_advance(frame, {1e9, false, wire::usual_longest}, {&u, 1});
}

/// Sends such requests on end behind those that open a session, and reads no reply but the first.
void ask_without_reading(wire::Channel& channel, Type type) {
  std::uint64_t most = 0;
  Writer frame;
  try {
    for (std::uint32_t number = 1; number < 14; ++number) {
      wire::begin(frame, number == 1 ? Type::hello : number == 2 ? Type::initialize : type, number);
      if (number == 1) wire::put_hello(frame, {});
      if (number == 2) wire::put_initialize(frame, {0.0, 1e9, 1, {0.0}});
      if (number > 2) put_longest(frame, type, most);
      wire::finish(frame);
      channel.send(frame.bytes(), wire::in_seconds(2.0));
      if (number > 1) continue;
      const auto reply = channel.receive(wire::in_seconds(5.0));
      most = wire::read_hello(wire::Frame::read(reply, wire::usual_longest).payload, wire::all_capabilities)
                 .longest;
    }
  } catch (const Error&) {  // the server takes no more
  }
}

/// What a server takes then beyond what it had [MiB].
template <class Connect>
std::int64_t most_in_the_pipeline(const ServerProcess& server, const Connect& connected, Type type) {
  { EXPECT_EQ(initialize(*std::make_unique<Requests>(connected(server))), Type::samples); }
  const std::int64_t before = server.memory("VmHWM");
  const auto channel = connected(server);
  ask_without_reading(*channel, type);
  const std::int64_t taken = (server.memory("VmHWM") - before) / mebibyte;
  testing::Test::RecordProperty("mebibytes_of_" + std::string(wire::name(type)), static_cast<int>(taken));
  return taken;
}

constexpr std::int64_t promised = 160;  // MiB

/// Each in a process of its own, at an address with these options.
template <class Connect>
void expect_bounded(const std::string& address, const std::vector<std::string>& options,
                    const Connect& connected) {
  const int saves = address.starts_with("unix") ? 100'000 : 2000;
  EXPECT_LE(most_taken(ServerProcess(served_model, address, options), connected, saves), promised) << address;
  for (const Type type : {Type::ping, Type::advance}) {
    const ServerProcess server(served_model, address, options);
    EXPECT_LE(most_in_the_pipeline(server, connected, type), promised) << address << ", " << wire::name(type);
  }
}

TEST(ServerMemory, IsBoundedOverSockets) {
  const Scratch folder;
  const auto connected = [](const ServerProcess& server) { return connect(server.uri(), {}); };
  expect_bounded("tcp://127.0.0.1:0", {}, connected);
  expect_bounded("unix:" + (folder.path() / "socket").string(), {}, connected);
}

#if TANDEM_HAS_TLS
TEST(ServerMemory, IsBoundedOverTls) {
  const TlsFolder keys;
  expect_bounded(
      "tls://127.0.0.1:0",
      {"--key", keys.file("server.key").string(), "--authority", keys.file("authority.crt").string()},
      [&](const ServerProcess& server) { return connect(server.uri(), keys.settings("client")); });
}
#endif

#if TANDEM_HAS_ZEROMQ
TEST(ServerMemory, IsBoundedOverZeroMq) {
  expect_bounded("zmq:tcp://127.0.0.1:0", {},
                 [](const ServerProcess& server) { return zmq_connect(server.uri().substr(4), {}); });
}

TEST(ServerMemory, IsBoundedOverZeroMqWithKeys) {
  const CurveFolder keys;
  const ZmqSettings settings{
      .keys = {read_curve_key(keys.file("client.pub"), false), read_curve_key(keys.file("client"), true)},
      .server_key = read_curve_key(keys.file("server.pub"), false)};
  expect_bounded("zmq:tcp://127.0.0.1:0",
                 {"--key", keys.file("server").string(), "--client-key", keys.file("client.pub").string()},
                 [&](const ServerProcess& server) { return zmq_connect(server.uri().substr(4), settings); });
}
#endif

}  // namespace
}  // namespace tandem::test
