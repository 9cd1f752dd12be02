// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A server that runs out of threads, descriptors or memory: the session in question ends with a sentence, or
// the connection waits; all others live on.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "curve_pair.hpp"
#include "refusal.hpp"
#include "served.hpp"
#include "server_process.hpp"
#include "tls_pair.hpp"

namespace tandem::test {
namespace {

/// A session that is advanced from time to time.
class Session {
 public:
  explicit Session(const std::string& uri) : subsystem_(open(uri, all_sources())) {
    const double u0 = 0.0;
    Samples y = room();
    subsystem_->initialize(0.0, 1000.0, {&u0, 1}, y);
  }
  bool goes_on() {
    const Segment zero{1e9, 0.0, {}};
    const Signal u(&zero, 1, 0);
    Samples y = room();
    time_ += 1.0;
    return subsystem_->advance(time_, false, {&u, 1}, y).time > time_ - 1.0;
  }

 private:
  Samples room() {
    memory_.resize(static_cast<std::size_t>(100 * subsystem_->info().row_size()));
    return {memory_.data(), subsystem_->info().row_size(), 100};
  }
  std::unique_ptr<Subsystem> subsystem_;
  std::vector<double> memory_;
  double time_ = 0.0;
};

/// Addresses of each transport, with what a client says besides.
struct Place {
  std::string address, query;
  std::vector<std::string> options;
};

/// Its lines go to a program that has ended.
TEST(ServerLog, ThatNobodyReadsAnyMoreEndsNoSession) {
  Child server({"bash", "-c", "exec \"$0\" \"$@\" 2> >(true)", TANDEM_COMMAND, "serve", served_model,
                "--listen", "tcp://127.0.0.1:0"});
  const std::string uri = server.word_after(" at ");
  Session first(uri);
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(Session(uri).goes_on());
  EXPECT_TRUE(first.goes_on());
  server.signal(SIGTERM);
  EXPECT_EQ(server.status(), 0);
}

class ServerShortage : public testing::TestWithParam<std::string> {
 protected:
  Place place() const {
    if (GetParam() == "unix") return {"unix:" + (folder_.path() / "socket").string(), "", {}};
#if TANDEM_HAS_TLS
    if (GetParam() == "tls")
      return {
          "tls://127.0.0.1:0",
          "&" + tls_.query(),
          {"--key", tls_.file("server.key").string(), "--authority", tls_.file("authority.crt").string()}};
#endif
    return {GetParam() == "tcp" ? "tcp://127.0.0.1:0" : "zmq:tcp://127.0.0.1:0", "", {}};
  }
  Scratch folder_;
#if TANDEM_HAS_TLS
  TlsFolder tls_;
#endif
};

TEST_P(ServerShortage, OfThreadsTurnsAwayOnePeerAndKeepsTheOthers) {
  const Place at = place();
  ServerProcess server(served_model, at.address, at.options);
  const std::string uri = server.uri() + "?deadline=2" + at.query;
  Session first(uri);
  server.limit(RLIMIT_AS, static_cast<rlim_t>(server.memory("VmSize")) + (1 << 22));
  EXPECT_THROW(Session{uri}, Error);
  EXPECT_TRUE(server.logs("can make no thread"));
  EXPECT_TRUE(first.goes_on());
  server.limit(RLIMIT_AS, RLIM_INFINITY);
  EXPECT_TRUE(Session(uri).goes_on());
  EXPECT_TRUE(first.goes_on());
}

TEST_P(ServerShortage, OfDescriptorsMakesPeersWaitWithOneLineAndWithoutSpinning) {
  const Place at = place();
  ServerProcess server(served_model, at.address, at.options);
  const std::string uri = server.uri() + "?deadline=20" + at.query;
  Session first(uri);
  server.limit(RLIMIT_NOFILE, server.free_descriptor());
  std::thread second([&] { EXPECT_TRUE(Session(uri).goes_on()); });
  EXPECT_TRUE(server.logs("further connections wait: Too many open files"));
  const double before = server.seconds_of_processor();
  for (int k = 0; k < 20; ++k, ::usleep(50'000)) EXPECT_TRUE(first.goes_on());
  EXPECT_LT(server.seconds_of_processor() - before, 0.5) << "of a second";
  EXPECT_EQ(server.lines_with("further connections wait"), 1);
  server.limit(RLIMIT_NOFILE, 1024);
  second.join();
}

TEST_P(ServerShortage, OfMemoryEndsOneRequestAndKeepsTheSessions) {
  const Place at = place();
  ServerProcess server(served_model, at.address, at.options);
  const std::string uri = server.uri() + "?deadline=5" + at.query;
  Session first(uri), second(uri);
  const auto large = open(uri, all_sources());
  server.limit(RLIMIT_AS, static_cast<rlim_t>(server.memory("VmSize")) + (1 << 22));
  std::vector<double> memory(static_cast<std::size_t>(large->info().row_size()) * (1 << 20));
  Samples y(memory.data(), large->info().row_size(), 1 << 20);
  const double u0 = 0.0;
  EXPECT_TRUE(refuses(ErrorCode::internal, {server.uri(), "there is no memory"}, [&] {
    large->initialize(0.0, 1.0, {&u0, 1}, y);
  }));
  EXPECT_TRUE(first.goes_on());
  EXPECT_TRUE(second.goes_on());
}

std::vector<std::string> socket_kinds() {
  std::vector<std::string> kinds = {"tcp", "unix"};
#if TANDEM_HAS_TLS
  kinds.push_back("tls");
#endif
  return kinds;
}
INSTANTIATE_TEST_SUITE_P(Each, ServerShortage, testing::ValuesIn(socket_kinds()),
                         [](const auto& of) { return of.param; });

/// What is started has nothing of the server's sockets, so what is left of it keeps no port.
TEST(ServerDescriptors, DoNotLeakIntoProgramsThatAreStarted) {
  const Scratch folder;
  const std::string file = (folder.path() / "left").string();
  const std::string program = "spawn:sh -c 'sleep 1000 & ls -l /proc/$!/fd >" + file + "; echo $! >" + file +
                              ".process; exec " TANDEM_COMMAND " serve builtin:two_mass.slow'";
  std::string uri;
  {
    ServerProcess server(program, "tcp://127.0.0.1:0");
    uri = server.uri();
    std::filesystem::remove(file);  // of the trial at the start
    const Session session(uri);
    EXPECT_EQ(read_text(file).find("socket:"), read_text(file).rfind("socket:")) << read_text(file);
    server.child().signal(SIGKILL);
    server.child().status();
  }
  EXPECT_NO_THROW(listen(uri, {})) << "a grandchild keeps the port";
  ::kill(std::stoi(read_text(file + ".process")), SIGKILL);
}

/// Whose server is there, though it takes nobody now.
TEST(ServerDescriptors, AUnixSocketWithAFullQueueIsInUseAndNotWaitedFor) {
  const Scratch folder;
  const std::string path = (folder.path() / "socket").string();
  sockaddr_un place{};
  place.sun_family = AF_UNIX;
  path.copy(place.sun_path, sizeof place.sun_path - 1);
  const auto* const name = reinterpret_cast<const sockaddr*>(&place);
  const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(server, name, sizeof place), 0);
  ASSERT_EQ(::listen(server, 0), 0);
  std::vector<int> queue;
  do queue.push_back(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
  while (::connect(queue.back(), name, sizeof place) == 0);
  Child second({TANDEM_COMMAND, "--quiet", "serve", served_model, "--listen", "unix:" + path});
  EXPECT_TRUE(ends(second.process()));
  second.signal(SIGKILL);  // one that has ended does not mind
  EXPECT_EQ(second.status(), 2);
  EXPECT_TRUE(std::filesystem::exists(path));
  for (const int client : queue) ::close(client);
  ::close(server);
}

TEST(ServerDescriptors, AUnixSocketThatAnotherServerHasReplacedStays) {
  const Scratch folder;
  const std::string path = (folder.path() / "socket").string();
  auto first = listen("unix:" + path, {});
  std::filesystem::remove(path);
  const Served second(listen("unix:" + path, {}), source(served_model));
  first.reset();
  EXPECT_TRUE(Session("unix:" + path).goes_on());
}

}  // namespace
}  // namespace tandem::test
