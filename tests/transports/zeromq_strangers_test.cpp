// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Who comes to the port of a ZeroMQ session that is not its own changes nothing and ends nothing.
#if TANDEM_HAS_ZEROMQ
#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <thread>
#include <zmq.hpp>

#include "curve_pair.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::test {
namespace {

std::vector<Recording::Rows> masses(Subsystem& slow) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

/// Opens and closes connections at a port of this machine, some with a word, until it is told to end.
void scan(int port, const std::atomic<bool>& end) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const std::string line = "GET / HTTP/1.1\r\n\r\n";
  for (int k = 0; !end; ++k) {
    const int stranger = ::socket(AF_INET, SOCK_STREAM, 0);
    if (::connect(stranger, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0 && k % 2)
      static_cast<void>(::send(stranger, line.data(), line.size(), MSG_NOSIGNAL));
    ::close(stranger);
    ::usleep(500);
  }
}

/// Another peer at a session's place: it says bye and initialize, and takes what comes, until it is told to
/// end. Counts the replies that it got.
int intrude(const std::string& place, const CurveFolder* keys, const std::atomic<bool>& end) {
  zmq::context_t context;
  zmq::socket_t peer(context, zmq::socket_type::dealer);
  peer.set(zmq::sockopt::linger, 0);
  if (keys) {
    peer.set(zmq::sockopt::curve_serverkey, read_curve_key(keys->file("server.pub"), false));
    peer.set(zmq::sockopt::curve_publickey, read_curve_key(keys->file("client.pub"), false));
    peer.set(zmq::sockopt::curve_secretkey, read_curve_key(keys->file("client"), true));
  }
  peer.connect(place);
  int replies = 0;
  for (std::uint32_t number = 1; !end; ++number) {
    wire::Writer frame;
    wire::begin(frame, number % 2 ? wire::Type::bye : wire::Type::initialize, number);
    if (number % 2 == 0) wire::put_initialize(frame, {0.0, 1.0, 1, {0.0}});
    wire::finish(frame);
    peer.send(zmq::const_buffer(frame.bytes().data(), frame.size()), zmq::send_flags::dontwait);
    zmq::message_t reply;
    replies += peer.recv(reply, zmq::recv_flags::dontwait).has_value();
    ::usleep(200);
  }
  return replies;
}

/// Runs the masses while strangers are at the session's port.
void run_among_strangers(const std::string& address, const ZmqSettings& settings, const std::string& query,
                         const CurveFolder* keys) {
  const Served server(zmq_listen(address, settings), source("builtin:two_mass.slow"));
  const auto slow = open(server.address() + "?frequency_ratio=30.7" + query, all_sources());
  const std::string log = server.log().at(0);
  const std::string place = log.substr(4, log.find(": session") - 4);
  std::atomic<bool> end = false;
  int replies = 0;
  std::thread scanner, intruder([&] { replies = intrude(place, keys, end); });
  if (place.starts_with("tcp:"))
    scanner = std::thread([&] { scan(std::stoi(place.substr(place.rfind(':') + 1)), end); });
  const auto inner = open("builtin:two_mass.slow?frequency_ratio=30.7", all_sources());
  for (int k = 0; k < 5; ++k) {
    EXPECT_TRUE(same_bits(masses(*slow), masses(*inner))) << place;
    const StateId state = slow->save_state();
    EXPECT_EQ(slow->serialize_state(state).size(), inner->serialize_state(inner->save_state()).size());
    slow->restore_state(state);
    slow->release_state(state);
  }
  end = true;
  intruder.join();
  if (scanner.joinable()) scanner.join();
  EXPECT_EQ(replies, 0);
  for (const std::string& line : server.log()) EXPECT_EQ(line.find("ends"), std::string::npos) << line;
}

TEST(ZeroMqStrangers, EndNoPlainSessionAndAreNotHeard) {
  const Scratch folder;
  run_among_strangers("tcp://127.0.0.1:0", {}, "", nullptr);
  run_among_strangers("ipc://" + (folder.path() / "socket").string(), {}, "", nullptr);
}

TEST(ZeroMqStrangers, EndNoSessionWithKeysThoughTheyAreLetInAsOthers) {
  const CurveFolder keys, other;
  ZmqSettings settings = keys.settings();
  settings.clients.push_back(read_curve_key(other.file("client.pub"), false));
  std::filesystem::copy_file(keys.file("server.pub"), other.file("server.pub"),
                             std::filesystem::copy_options::overwrite_existing);
  run_among_strangers("tcp://127.0.0.1:0", settings, "&" + keys.query(), &other);
}

/// A session that begins with these parts of a knock, and where its socket is; null if there is none.
struct Knocked {
  std::unique_ptr<wire::Channel> session;
  zmq::message_t place;
};
Knocked knock(wire::Listener& listener, zmq::context_t& context, const std::vector<std::string>& parts) {
  zmq::socket_t door(context, zmq::socket_type::dealer);
  door.set(zmq::sockopt::linger, 0);
  door.connect(listener.address().substr(4));
  for (std::size_t k = 0; k < parts.size(); ++k)
    door.send(zmq::buffer(parts[k]), k + 1 < parts.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
  Knocked answer;
  const auto end = wire::in_seconds(0.5);
  while (!answer.session && std::chrono::steady_clock::now() < end)
    answer.session = listener.accept(wire::in_seconds(0.1));
  EXPECT_TRUE(!answer.session || door.recv(answer.place));
  return answer;
}

/// Connections to a port, each accepted at the lowest numbers of descriptors that this process has free.
std::vector<int> crowd(int port, int count) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::vector<int> all;
  for (int k = 0; k < count; ++k) {
    const int low = ::socket(AF_INET, SOCK_STREAM, 0);
    all.push_back(::fcntl(low, F_DUPFD, 500));
    ::close(low);
    EXPECT_EQ(::connect(all.back(), reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
    ::usleep(1000);
  }
  return all;
}

/// ZeroMQ tells of ends by descriptors, which are used again at once.
TEST(ZeroMqStrangers, WhoGetThePeersDescriptorDoNotHideItsEnd) {
  const auto listener = zmq_listen("tcp://127.0.0.1:0", {});
  zmq::context_t context;
  const auto [session, place] = knock(*listener, context, {"TANDEM\r\n", "a token of mine"});
  ASSERT_TRUE(session);
  zmq::socket_t peer(context, zmq::socket_type::dealer);
  peer.set(zmq::sockopt::routing_id, "a token of mine");
  peer.connect(place.to_string());
  peer.send(zmq::str_buffer("the peer's"), zmq::send_flags::none);
  EXPECT_FALSE(session->receive(wire::in_seconds(5.0)).empty());
  peer.close();
  const std::string address = place.to_string();
  const auto strangers = crowd(std::stoi(address.substr(address.rfind(':') + 1)), 50);
  EXPECT_TRUE(session->wait(wire::in_seconds(2.0))) << "the peer is gone";
  for (const int stranger : strangers) ::close(stranger);
}

TEST(ZeroMqStrangers, AKnockThatIsNoneGetsNoSession) {
  const auto listener = zmq_listen("tcp://127.0.0.1:0", {});
  zmq::context_t context;
  const std::string tandem = "TANDEM\r\n";
  for (const std::vector<std::string>& parts :
       std::vector<std::vector<std::string>>{{"GET / HTTP/1.1"},
                                             {tandem, ""},
                                             {tandem, std::string(65, 'x')},
                                             {tandem, std::string(300, 'x')},
                                             {tandem, "a token", "more"},
                                             {tandem, "a token", "more", "and more"}})
    EXPECT_FALSE(knock(*listener, context, parts).session)
        << parts.size() << " parts, " << parts.back().size();
  EXPECT_TRUE(knock(*listener, context, {tandem, std::string(64, 'x')}).session);
  EXPECT_TRUE(knock(*listener, context, {tandem, "x"}).session);
}

/// There is nobody to be told that the session ends.
TEST(ZeroMqStrangers, WhoKnockAndStayAwayHoldAPlaceForOneDeadline) {
  const auto listener = zmq_listen("tcp://127.0.0.1:0", {});
  zmq::context_t context;
  const auto [channel, place] = knock(*listener, context, {"TANDEM\r\n", "a token of mine"});
  ASSERT_TRUE(channel);
  wire::Session session(*channel, {}, {.deadline = 1.0});
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW(session.serve(), Error);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(1900));
}

/// Before its peer is in: who comes first is not the peer.
TEST(ZeroMqStrangers, TakeNoPlaceBeforeThePeerIsThere) {
  const auto listener = zmq_listen("tcp://127.0.0.1:0", {});
  zmq::context_t context;
  const auto [session, place] = knock(*listener, context, {"TANDEM\r\n", "a token of mine"});
  ASSERT_TRUE(session);
  zmq::socket_t stranger(context, zmq::socket_type::dealer), peer(context, zmq::socket_type::dealer);
  for (zmq::socket_t* socket : {&stranger, &peer}) socket->set(zmq::sockopt::linger, 0);
  stranger.connect(place.to_string());
  stranger.send(zmq::str_buffer("a frame of mine"), zmq::send_flags::none);
  EXPECT_FALSE(session->wait(wire::in_seconds(0.2)));
  peer.set(zmq::sockopt::routing_id, "a token of mine");
  peer.connect(place.to_string());
  peer.send(zmq::str_buffer("the peer's"), zmq::send_flags::none);
  const auto frame = session->receive(wire::in_seconds(5.0));
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(frame.data()), frame.size()), "the peer's");
  stranger.close();
  EXPECT_FALSE(session->wait(wire::in_seconds(0.2))) << "the stranger's end is not the peer's";
  peer.close();
  EXPECT_TRUE(session->wait(wire::in_seconds(5.0)));
  EXPECT_TRUE(session->receive(wire::in_seconds(5.0)).empty());
}

/// A listening socket at a port of this machine that was just given up.
int listen_at(int port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0), yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  EXPECT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
  EXPECT_EQ(::listen(socket, 5), 0);
  return socket;
}

/// A client of ZeroMQ would connect again by itself, and send them what it has not yet sent.
TEST(ZeroMqStrangers, WhoTakeTheServersPortGetNothingOfItsClients) {
  const auto listener = zmq_listen("tcp://127.0.0.1:0", {});
  std::unique_ptr<wire::Channel> client;
  std::thread calling([&] { client = zmq_connect(listener->address().substr(4), {}); });
  auto session = listener->accept(wire::in_seconds(5.0));
  calling.join();
  ASSERT_TRUE(session && client);
  const std::byte word[1] = {};
  client->send(word, wire::in_seconds(5.0));
  EXPECT_FALSE(session->receive(wire::in_seconds(5.0)).empty());
  const std::string address = session->peer();
  session.reset();
  EXPECT_TRUE(client->wait(wire::in_seconds(5.0)));
  const int stranger = listen_at(std::stoi(address.substr(address.rfind(':') + 1)));
  pollfd there{stranger, POLLIN, 0};
  EXPECT_EQ(::poll(&there, 1, 500), 0) << "a client tries again after 0.1 s";
  ::close(stranger);
}

/// As it was before there were tokens.
TEST(ZeroMqStrangers, AKnockWithoutATokenGetsASessionOfWhoSpeaksFirst) {
  const auto listener = zmq_listen("tcp://127.0.0.1:0", {});
  zmq::context_t context;
  const auto [session, place] = knock(*listener, context, {"TANDEM\r\n"});
  ASSERT_TRUE(session);
  zmq::socket_t peer(context, zmq::socket_type::dealer), second(context, zmq::socket_type::dealer);
  for (zmq::socket_t* socket : {&second, &peer}) socket->set(zmq::sockopt::linger, 0);
  peer.connect(place.to_string());
  peer.send(zmq::str_buffer("first"), zmq::send_flags::none);
  EXPECT_FALSE(session->receive(wire::in_seconds(5.0)).empty());
  second.connect(place.to_string());
  second.send(zmq::str_buffer("second"), zmq::send_flags::none);
  EXPECT_FALSE(session->wait(wire::in_seconds(0.2)));
}

}  // namespace
}  // namespace tandem::test
#endif
