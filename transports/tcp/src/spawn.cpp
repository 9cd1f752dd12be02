// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

#include "end_with_parent.hpp"
#include "stream.hpp"
#include "tandem/error.hpp"
#include "tandem/tcp/tcp.hpp"

extern char** environ;

namespace tandem {
namespace tcp {
namespace {

[[noreturn]] void fail(const std::string& command, const char* what) {
  throw Error(ErrorCode::input_output,
              "program '" + command + "' can't be started: " + what + ": " + std::strerror(errno));
}

/// A program with one end of a socket. It is a group of its own, so that the terminal's Ctrl-C does not reach
/// it before this process has ended the run.
class Program {
 public:
  Program(const std::string& command, const std::string& folder, int& our_end) : command_(command) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail(command, "socketpair");
    // All that allocates is done before the fork.
    const std::string line = "exec " + command, variable = "TANDEM_FD=" + std::to_string(ends[1]);
    const char* arguments[] = {"sh", "-c", line.c_str(), nullptr};
    std::vector<const char*> variables;
    for (char** v = environ; *v; ++v)
      if (std::strncmp(*v, "TANDEM_FD=", 10) != 0) variables.push_back(*v);
    variables.push_back(variable.c_str());
    variables.push_back(nullptr);
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ == 0) {
      ::setpgid(0, 0);
      end_with_parent(parent);
      ::fcntl(ends[1], F_SETFD, 0);
      if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
      ::execve("/bin/sh", const_cast<char**>(arguments), const_cast<char**>(variables.data()));
      ::_exit(127);
    }
    ::close(ends[1]);
    our_end = ends[0];
    if (process_ < 0) {
      ::close(ends[0]);
      fail(command, "fork");
    }
  }
  /// By now its socket is closed: a program that reads it ends of its own accord, others are told to. What it
  /// has started and left is in its group, and goes with it.
  ~Program() {
    if (!ended_within(1.0)) ::kill(-process_, SIGTERM);
    ended_within(1.0);
    ::kill(-process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// It keeps its number until ~Program, so that nobody else has it.
  bool ended_within(double seconds) {
    const auto deadline = wire::in_seconds(seconds);
    for (auto pause = std::chrono::microseconds(100); !ended_; pause = std::min(2 * pause, longest_pause)) {
      const int failed = ::waitid(P_PID, static_cast<id_t>(process_), &end_, WEXITED | WNOHANG | WNOWAIT);
      ended_ = end_.si_pid == process_ || (failed && errno == ECHILD);
      if (!ended_ && std::chrono::steady_clock::now() > deadline) return false;
      if (!ended_) std::this_thread::sleep_for(pause);
    }
    return true;
  }

  /// What became of it.
  std::string fate() {
    const std::string who = "program '" + command_ + "' ";
    if (!ended_within(0.2)) return who + "closed its socket";
    const int code = end_.si_status;
    if (end_.si_code != CLD_EXITED) return who + "was ended by signal " + std::to_string(code);
    return who + "ended with status " + std::to_string(code) +
           (code == 127   ? " (not found?)"
            : code == 126 ? " (no such folder, or not executable)"
                          : "");
  }

 private:
  static constexpr std::chrono::microseconds longest_pause{10'000};
  std::string command_;
  pid_t process_ = -1;
  siginfo_t end_ = {};
  bool ended_ = false;
};

/// The channel to a program, which ends with it.
class SpawnedChannel final : public wire::Channel {
  /// An error of the connection says what became of the program, if that is the reason.
  template <class Call>
  auto told(const Call& call) {
    try {
      return call();
    } catch (const Error& error) {
      if (!program_.ended_within(0.1)) throw;
      throw Error(error.code(), program_.fate());
    }
  }

 public:
  SpawnedChannel(const std::string& command, const std::string& folder, const SocketSettings& settings)
      : peer_("spawn:" + command), program_(command, folder, our_end_) {
    channel_ = adopt(our_end_, peer_, settings);
  }

  void send(std::span<const std::byte> frame, wire::Deadline deadline) override {
    told([&] { channel_->send(frame, deadline); });
  }
  std::span<const std::byte> receive(wire::Deadline deadline) override {
    const auto frame = told([&] { return channel_->receive(deadline); });
    if (frame.empty()) throw Error(ErrorCode::input_output, program_.fate());
    return frame;
  }
  bool wait(wire::Deadline deadline) override { return channel_->wait(deadline); }
  void close() noexcept override { channel_->close(); }
  const std::string& peer() const override { return peer_; }

 private:
  std::string peer_;
  int our_end_ = -1;
  Program program_;
  std::unique_ptr<wire::Channel> channel_;  // goes before the program, which ends when its socket is closed
};

}  // namespace
}  // namespace tcp

std::unique_ptr<wire::Channel> spawn(const std::string& command, const std::string& folder,
                                     const SocketSettings& settings) {
  return std::make_unique<tcp::SpawnedChannel>(command, folder, settings);
}

}  // namespace tandem
