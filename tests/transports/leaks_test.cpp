// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sessions that end well and badly leave nothing behind, on either side.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "curve_pair.hpp"
#include "served.hpp"
#include "this_process.hpp"
#include "tls_pair.hpp"

namespace tandem::test {
namespace {

/// Open files and threads of this process.
struct Held {
  std::ptrdiff_t files = open_files(), threads = running_threads();
};

/// Within 10 s; what ends does so in other threads.
testing::AssertionResult comes_back_to(const Held& before) {
  Held now;
  for (int k = 0; k < 10000; ++k, ::usleep(1000)) {
    now = Held();
    if (now.files <= before.files && now.threads <= before.threads) return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "files " << before.files << " -> " << now.files << ", threads "
                                     << before.threads << " -> " << now.threads;
}

/// A session that computes and says bye, one that breaks its order, and one that is refused.
void use(const std::string& uri) {
  const auto s = open(uri, all_sources());
  std::vector<double> memory(static_cast<std::size_t>(s->info().row_size()));
  Samples y(memory.data(), s->info().row_size(), 1);
  const double u0 = 0.0;
  s->initialize(0.0, 1.0, {&u0, 1}, y);
  const auto early = open(uri, all_sources());
  EXPECT_THROW(early->advance(1.0, false, {}, y), Error);
  const std::string wrong = uri + (uri.find('?') == std::string::npos ? "?" : "&") + "no_such_parameter=1";
  EXPECT_THROW(open(wrong, all_sources()), Error);
}

void leaves_nothing(const std::string& uri) {
  use(uri);  // what is made once is there from now on
  const Held before;
  for (int k = 0; k < 20; ++k) use(uri);
  EXPECT_TRUE(comes_back_to(before)) << uri;
}

constexpr const char* slow = "builtin:two_mass.slow";

TEST(Leaks, TcpAndUnixSocketsLeaveNothing) {
  const Scratch folder;
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    const Served server(listen(address, {}), source(slow));
    leaves_nothing(server.address());
  }
}

TEST(Leaks, ProgramsThatAreStartedLeaveNoProcess) {
  leaves_nothing(std::string("spawn:") + TANDEM_COMMAND + " serve " + slow);
  EXPECT_THROW(open("spawn:sh -c 'exit 3'", all_sources()), Error);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD) << "a child is left";
}

#if TANDEM_HAS_TLS
TEST(Leaks, TlsLeavesNothing) {
  const TlsFolder keys, strangers;
  const Served server(listen("tls://127.0.0.1:0", keys.settings()), source(slow));
  leaves_nothing(server.address() + "?" + keys.query());
  const Held before;
  for (int k = 0; k < 20; ++k)
    EXPECT_THROW(open(server.address() + "?" + strangers.query(), all_sources()), Error);
  EXPECT_TRUE(comes_back_to(before)) << "after handshakes that fail";
}
#endif

#if TANDEM_HAS_ZEROMQ
TEST(Leaks, ZeroMqLeavesNothing) {
  const CurveFolder keys;
  const Served plain(zmq_listen("tcp://127.0.0.1:0", {}), source(slow));
  leaves_nothing(plain.address());
  const Served secure(zmq_listen("tcp://127.0.0.1:0", keys.settings()), source(slow));
  leaves_nothing(secure.address() + "?" + keys.query());
}
#endif

}  // namespace
}  // namespace tandem::test
