// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sources in second processes: the command `tandem serve`, and programs that are started.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <sstream>
#include <thread>

#include "child.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"

namespace tandem::test {
namespace {

const std::string command = TANDEM_COMMAND;

std::vector<Recording::Rows> served_masses(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}
const std::string ratio = "?frequency_ratio=30.7";

TEST(Serve, GivesTheSameBitsAndEndsOnSigterm) {
  const Scratch folder;
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    Child server({command, "serve", "builtin:two_mass.slow", "--listen", address});
    const std::string at = server.word_after(" at ");
    EXPECT_TRUE(same_bits(served_masses(at + ratio), served_masses("builtin:two_mass.slow" + ratio)));
    const auto held = open(at, all_sources());  // a session that is open does not keep it
    server.signal(SIGTERM);
    EXPECT_EQ(server.status(), 0);
  }
}

/// A call of a model that takes an hour.
class ServeAModelThatComputes : public testing::Test {
 protected:
  ServeAModelThatComputes() : at_(server_.word_after(" at ")) {
    caller_ = std::thread([this] {
      try {
        RunBench().add("it", *open(at_ + "?deadline=100", all_sources())).run(1.0);
      } catch (const Error&) {  // the server's end
      }
    });
    server_.word_after("computes ");
  }
  ~ServeAModelThatComputes() override { caller_.join(); }

  Scratch folder_;
  Child server_{{command, "--log", (folder_.path() / "log").string(), "serve",
                 "lib:" TANDEM_FAULTY_LIBRARY "?entry=computes_on", "--deadline", "0.5", "--listen",
                 "tcp://127.0.0.1:0"}};
  const std::string at_;
  std::thread caller_;
};

TEST_F(ServeAModelThatComputes, EndsADeadlineAfterSigterm) {
  server_.signal(SIGTERM);
  EXPECT_EQ(server_.status(), 1);
  EXPECT_NE(read_text(folder_.path() / "log")
                .find("1 session is still computing 0.5 s after the end was asked for"),
            std::string::npos);
}

TEST_F(ServeAModelThatComputes, EndsAtOnceBySecondSignalOfEitherKind) {
  server_.signal(SIGTERM);
  ::usleep(50'000);
  server_.signal(SIGINT);
  EXPECT_EQ(server_.status(), -SIGINT);
}

#if TANDEM_HAS_TLS
TEST(Serve, TlsWithTheFilesOfTandemKeys) {
  const Scratch folder;
  const std::string keys = (folder.path() / "keys").string();
  EXPECT_EQ(Child({command, "--quiet", "keys", keys, "--days", "1"}).status(), 0);
  EXPECT_EQ(Child({command, "--quiet", "keys", keys}).status(), 2) << "nothing is overwritten";
  Child server({command, "serve", "builtin:two_mass.slow", "--listen", "tls://127.0.0.1:0", "--key",
                keys + "/server.key", "--authority", keys + "/authority.crt"});
  const std::string uri =
      server.word_after(" at ") + ratio + "&key=" + keys + "/client.key&authority=" + keys + "/authority.crt";
  EXPECT_TRUE(same_bits(served_masses(uri), served_masses("builtin:two_mass.slow" + ratio)));
}
#endif

/// One is whose peer has said hello, though it may have been refused.
TEST(Serve, OnceEndsAfterOneSessionThatIsNoPortScan) {
  const std::vector<std::string> words = {command,  "serve",    "builtin:two_mass.slow",
                                          "--once", "--listen", "tcp://127.0.0.1:0"};
  Child server(words), other(words);
  const std::string address = server.word_after(" at ");
  scan_ports(address);
  { const auto session = open(address, all_sources()); }
  EXPECT_EQ(server.status(), 0);
  EXPECT_THROW(open(other.word_after(" at ") + "?no_such_parameter=1", all_sources()), Error);
  EXPECT_EQ(other.status(), 0);
}

TEST(Serve, RefusesWhatIsNotRightBeforeItListens) {
  const auto status = [](std::vector<std::string> words) {
    words.insert(words.begin(), {command, "serve", "builtin:two_mass.slow"});
    return Child(words).status();
  };
  EXPECT_EQ(status({}), 2);
  EXPECT_EQ(status({"--listen", "tcp://0.0.0.0:0"}), 2);
  EXPECT_EQ(status({"--listen", "nonsense"}), 2);
  EXPECT_EQ(status({"--listen", "tls://127.0.0.1:0"}), 2) << "without a key";
  EXPECT_EQ(status({"--listen", "tcp://127.0.0.1:0", "--key", "key"}), 2) << "with one of no use";
  EXPECT_EQ(status({"--listen", "unix:socket?spin=0"}), 2) << "which no client could name";
  for (const std::string number : {"--deadline", "--idle", "--spin"})
    EXPECT_EQ(status({"--listen", "tcp://127.0.0.1:0", number, "nan"}), 2) << number;
}

TEST(Serve, RefusesASourceThatIsNotThereAndServesOneThatNeedsAClientsParameters) {
  const Scratch folder;
  const std::string file =
      folder
          .write("x.toml",
                 "[blocks]\nx = { kind = 'integrator', input = 'x' }\n[outputs]\nx = { unit = '1' }\n")
          .string();
  for (const std::string source : {"builtin:nope", "nope:x", "diagram:nope.toml", "lib:./nope.so"})
    EXPECT_EQ(Child({command, "serve", source, "--listen", "tcp://127.0.0.1:0"}).status(), 2) << source;
  const std::string lib =
      "lib:" TANDEM_FAULTY_LIBRARY;  // has no entry of the usual name, which no client may give
  EXPECT_EQ(Child({command, "serve", lib, "--listen", "tcp://127.0.0.1:0"}).status(), 2);
  EXPECT_EQ(Child({"sh", "-c",
                   "exec '" TANDEM_COMMAND "' serve builtin:two_mass.slow --listen unix:'" +
                       folder.path().string() + "' 2>&1"})
                .word_after("something is "),
            "there;");
  Child server({command, "serve", "diagram:" + file, "--listen", "tcp://127.0.0.1:0", "--once"});
  EXPECT_EQ(open(server.word_after(" at ") + "?step=0.1", all_sources())->info().output_size(), 1);
}

/// The first one waits for the reply; if none is under way, it is enough.
TEST(Serve, ASecondCtrlCEndsARunThatWaitsForAServer) {
  const Scratch folder;
  Child server({command, "serve", "builtin:two_mass.slow", "--listen", "tcp://127.0.0.1:0"});
  Child run({command, "--quiet", "run", TANDEM_SOURCE_DIR "/scenarios/two_mass/two_mass.toml",
             "--no-reference", "--set",
             "subsystems.slow.source=" + server.word_after(" at ") + "?deadline=1000", "--set",
             "span.stop=1e9", "--output", folder.path().string()});
  while (!std::filesystem::exists(folder.path() / "results.csv")) ::usleep(1000);
  server.signal(SIGSTOP);
  for (int k = 0; k < 5000 && !is_gone(run.process()); ++k) run.signal(SIGINT), ::usleep(1000);
  EXPECT_TRUE(is_gone(run.process()));
}

TEST(Spawn, GivesTheSameBitsAndEndsItsProgramWithTheRun) {
  const std::string uri = "spawn:" + command + " serve builtin:two_mass.slow";
  EXPECT_TRUE(same_bits(served_masses(uri + ratio), served_masses("builtin:two_mass.slow" + ratio)));
  const Scratch folder;
  const std::string file = (folder.path() / "process").string();
  pid_t process = 0;
  {
    const auto s =
        open("spawn:sh -c 'echo $$ > " + file + "; exec " + command + " serve builtin:two_mass.slow'",
             all_sources());
    process = std::stoi(read_text(file));
    EXPECT_FALSE(is_gone(process));
  }
  EXPECT_TRUE(is_gone(process));
}

TEST(Spawn, WhatItsProgramHasStartedAndLeftEndsToo) {
  const Scratch folder;
  const std::string file = (folder.path() / "process").string();
  {
    const auto s = open(
        "spawn:sh -c 'sleep 1000 & echo $! > " + file + "; exec " + command + " serve builtin:two_mass.slow'",
        all_sources());
    EXPECT_FALSE(is_gone(std::stoi(read_text(file))));
  }
  EXPECT_TRUE(ends(std::stoi(read_text(file))));
}

/// Variables, changes of folder and chains of commands as in a shell; the last that serves is the subsystem.
TEST(Spawn, IsWhatTheShellDoesWithTheCommand) {
  const std::string serve = command + " serve builtin:two_mass.slow";
  for (const std::string& line :
       {"X=1 Y=2 " + serve, "cd / && " + serve, "true; " + serve, "(" + serve + ")", "false || " + serve,
        serve + " 2>/dev/null | cat", "for k in 1; do " + serve + "; done", "exec " + serve}) {
    EXPECT_TRUE(
        same_bits(served_masses("spawn:" + line + ratio), served_masses("builtin:two_mass.slow" + ratio)))
        << line;
  }
}

TEST(Spawn, AProgramThatEndsOrIsNotThereIsNamedWithItsStatus) {
  const auto opening = [](const std::string& uri) { return [uri] { open(uri, all_sources()); }; };
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"hello", "ended with status 3"}, opening("spawn:sh -c 'exit 3'")));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"'no_such_program'", "127"}, opening("spawn:no_such_program")));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"signal 6"}, opening("spawn:sh -c 'kill -ABRT $$'")));
  EXPECT_TRUE(refuses(ErrorCode::input_output,
                      {"spawn:sleep 60", "no reply came within the deadline of 0.2 s"},
                      opening("spawn:sleep 60?deadline=0.2")));
}

/// Also what it has started, and what does not look at the socket.
TEST(Spawn, TheWholeGroupEndsWhenTheRunIsKilled) {
  for (const char* origin :
       {"source = \"spawn:sleep 1000 & sleep 1000 & echo $$ $! > processes; wait\"",
        "source = \"spawn:cd . && sh -c 'sleep 1000 & echo $$ $! > processes; wait' && true\"",
        "command = [\"sh\", \"-c\", \"sleep 1000 & echo $$ $! > processes; wait\"]"}) {
    const Scratch folder;
    const auto scenario = folder.write("run.toml", std::string("[subsystems.s]\n") + origin +
                                                       "\nparameters.deadline = 100\n[span]\nstop = 1.0\n");
    Child run({command, "run", scenario.string(), "--output", folder.path().string()});
    while (!read_text(folder.path() / "processes").ends_with('\n')) ::usleep(1000);
    pid_t program = 0, grandchild = 0;
    std::istringstream(read_text(folder.path() / "processes")) >> program >> grandchild;
    run.signal(SIGKILL);
    EXPECT_EQ(run.status(), -SIGKILL);
    EXPECT_TRUE(ends(program)) << origin;
    EXPECT_TRUE(ends(grandchild)) << origin;
  }
}

/// A thread that has made a subsystem may go before it.
TEST(Spawn, TheProgramLivesOnWithoutTheThreadThatStartedIt) {
  std::unique_ptr<Subsystem> s;
  std::thread([&] { s = open("spawn:" + command + " serve builtin:two_mass.slow", all_sources()); }).join();
  std::vector<double> row(static_cast<std::size_t>(s->info().row_size()));
  Samples y(row.data(), s->info().row_size(), 1);
  EXPECT_EQ(s->initialize(0.0, 1.0, std::vector<double>(1, 0.5), y).time, 0.0);
}

}  // namespace
}  // namespace tandem::test
