// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "served.hpp"
#include "tls_pair.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

#if TANDEM_HAS_TLS

const std::string here = "tls://127.0.0.1:0", parameters = "?frequency_ratio=30.7";

std::vector<Recording::Rows> tls_masses(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast" + parameters, all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

auto opening_tls(const std::string& address, const std::string& query) {
  return [=] { open(address + "?deadline=2&" + query, all_sources()); };
}

TEST(Tls, TwoMassesGiveTheSameBitsAsInOneProcess) {
  const TlsFolder keys;
  const Served server(listen(here, keys.settings()), source("builtin:two_mass.slow"));
  EXPECT_TRUE(same_bits(tls_masses(server.address() + parameters + "&" + keys.query()),
                        tls_masses("builtin:two_mass.slow" + parameters)));
}

TEST(Tls, OnlyTheOtherSideOfThePairIsTalkedTo) {
  const TlsFolder keys, strangers;
  const Served server(listen(here, keys.settings()), source("builtin:two_mass.slow"));
  const std::string key = "key=" + strangers.file("client.key").string();
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {server.address(), "hello", "alert unknown ca"},
              opening_tls(server.address(), key + "&authority=" + keys.file("authority.crt").string())));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"certificate is refused"},
                      opening_tls(server.address(), strangers.query())));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {server.address(), "alert"},
                      opening_tls(server.address(), keys.query("server"))))
      << "the server's own certificate is none of a client";
  const Served swapped(listen(here, keys.settings("client")), source("builtin:two_mass.slow"));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"certificate is refused"},
                      opening_tls(swapped.address(), keys.query())))
      << "the client's certificate is none of a server";
  EXPECT_NO_THROW(opening_tls(server.address(), keys.query())());
}

TEST(Tls, CertificatesThatHaveExpiredAreRefused) {
  const TlsFolder expired(-1.0);
  const Served server(listen(here, expired.settings()), source("builtin:two_mass.slow"));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {server.address(), "certificate has expired"},
                      opening_tls(server.address(), expired.query())));
}

TEST(Tls, PlainTextOnEitherSideIsRefused) {
  const TlsFolder keys;
  const Served secure(listen(here, keys.settings()), source("builtin:two_mass.slow"));
  const Served plain(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"hello", "handshake failed", "TLS 1.3"},
                      opening_tls("tls" + plain.address().substr(3), keys.query())));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"hello", "the peer closed the connection"},
                      opening_tls("tcp" + secure.address().substr(3), "frequency_ratio=25")));
}

TEST(Tls, ASilentPeerIsLeftAtTheDeadlineOfTheHandshakeOnBothSides) {
  const TlsFolder keys;
  const auto mute = listen("tcp://127.0.0.1:0", {});
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"handshake did not end within the deadline"}, [&] {
    open("tls" + mute->address().substr(3) + "?deadline=0.1&" + keys.query(), all_sources());
  }));
  SocketSettings brief = keys.settings();
  brief.deadline = 0.1;
  const auto listener = listen(here, brief);
  const auto client = connect("tcp" + listener->address().substr(3), {});
  const auto channel = listener->accept(wire::in_seconds(5.0));
  ASSERT_TRUE(channel);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"handshake did not end within the deadline"},
                      [&] { channel->wait(wire::in_seconds(3600.0)); }));
}

TEST(Tls, FilesThatCanNotBeUsedAreRefusedByName) {
  const TlsFolder keys, strangers;
  const auto listening = [](const SocketSettings& settings) { return [=] { listen(here, settings); }; };
  SocketSettings wrong = keys.settings();
  wrong.tls.authority = keys.file("none.crt");
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"certificate file", "none.crt' is not there"}, listening(wrong)));
  for (const std::string name : {"fifo.crt", "fifo.key"})
    ASSERT_EQ(::mkfifo(keys.file(name).c_str(), 0600), 0);
  wrong.tls.authority = keys.file("fifo.crt");
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"fifo.crt", "it is a FIFO; allowed is a regular file"},
                      listening(wrong)));
  wrong = keys.settings();
  wrong.tls.key = keys.file("fifo.key");
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"key file", "fifo.key", "it is a FIFO"}, listening(wrong)));
  fs::remove(keys.file("fifo.key"));
  fs::copy_file(keys.file("server.key"), keys.file("fifo.key"));  // its certificate is the FIFO
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"certificate file", "fifo.crt", "it is a FIFO"}, listening(wrong)));
  wrong = keys.settings();
  wrong.tls.key = keys.file("server.crt");
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"server.crt", "mode 600"}, listening(wrong)));
  fs::permissions(keys.file("server.crt"), fs::perms::owner_read);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"server.crt", "no private key"}, listening(wrong)));
  fs::remove(keys.file("client.crt"));
  fs::copy_file(strangers.file("client.crt"), keys.file("client.crt"));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"client.key", "is not that of", "client.crt"},
                      listening(keys.settings("client"))));
  fs::permissions(keys.file("server.key"), fs::perms::group_read, fs::perm_options::add);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"server.key", "mode 600"}, listening(keys.settings())));
  ::setenv("CREDENTIALS_DIRECTORY", fs::path(keys.file("server.key")).parent_path().c_str(), 1);
  EXPECT_NO_THROW(listening(keys.settings())()) << "a credential of systemd";
  fs::permissions(keys.file("server.key"), fs::perms::others_read, fs::perm_options::add);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"server.key", "mode 600"}, listening(keys.settings())));
  ::unsetenv("CREDENTIALS_DIRECTORY");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {here, "key=FILE&authority=FILE"}, listening({})));
}

TEST(Tls, GoesBeyondThisMachineWithoutPlainTextBeingAllowed) {
  const TlsFolder keys;
  const auto listener = listen("tls://0.0.0.0:0", keys.settings());
  EXPECT_EQ(listener->address().substr(0, 14), "tls://0.0.0.0:");
}

TEST(Tls, AServerThatEndsInARunIsToldPromptly) {
  const TlsFolder keys;
  auto server = std::make_unique<Served>(listen(here, keys.settings()), source("builtin:two_mass.both"));
  const std::string address = server->address();
  const auto both = open(address + "?" + keys.query(), all_sources());
  RunBench bench;
  Coordinator& run = bench.add("both", *both).make(10.0);
  run.initialize();
  server.reset();
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"'both'", address, "advance", "t = 0 s"}, [&] { run.round(); }));
}

#else

TEST(Tls, IsRefusedWithASentenceByABuildWithoutIt) {
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"tls://127.0.0.1:1", "libssl-dev"},
                      [] { open("tls://127.0.0.1:1?key=a&authority=b", all_sources()); }));
}

#endif

}  // namespace
}  // namespace tandem::test
