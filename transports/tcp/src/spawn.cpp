// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "descriptors.hpp"
#include "stream.hpp"
#include "tandem/error.hpp"
#include "tandem/library_file.hpp"
#include "tandem/process_group.hpp"
#include "tandem/start_process.hpp"
#include "tandem/tcp/tcp.hpp"
#include "tandem/transports/temporary_folder.hpp"

namespace tandem {
namespace tcp {
namespace {

/// A program with one end of a socket, in a group of its own, so that the terminal's Ctrl-C does not reach it
/// before this process has ended the run.
class Program {
 public:
  Program(const ProgramStart& start, Descriptor& our_end) : name_(start.name), group_(name_) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail_to_start(name_, "socketpair");
    our_end = Descriptor(ends[0]);
    const Descriptor its_end(ends[1]);
    std::vector<std::string> variables = {"TANDEM_FD=" + std::to_string(its_end.get())};
    if (start.isolates) variables.push_back("TMPDIR=" + temporary_.emplace().path().string());
    process_ = start_process({.words = start.words,
                              .kept = its_end.get(),
                              .folder = start.folder,
                              .variables = std::move(variables),
                              .group = group_.number(),
                              .name = name_});
  }
  /// By now its socket is closed: a program that reads it ends of its own accord, others are told to. What it
  /// has started and left is in its group, and goes with it.
  ~Program() {
    if (!ended_within(1.0))
      group_.signal(SIGTERM);
    else if (temporary_ && !(end_.si_code == CLD_EXITED && end_.si_status == 0))
      LibraryCall::note_bad_end();
    ended_within(1.0);
    if (!ended_) ::kill(process_, SIGKILL);  // by its own number: it may have left the group
    end_of_process(process_);
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

  /// Whether it has ended as no program should.
  bool has_faulted() const {
    return ended_ && (end_.si_code != CLD_EXITED || end_.si_status == LibraryCall::ended_by_library);
  }
  /// What became of it.
  std::string fate() {
    const std::string who = "program " + name_ + " ";
    if (!ended_within(0.2)) return who + "closed its socket";
    const int code = end_.si_status;
    if (end_.si_code != CLD_EXITED) return who + "was ended by signal " + std::to_string(code);
    if (code == LibraryCall::ended_by_library)
      return who + "was ended by a library in the middle of the work; allowed is to return";
    return who + "ended with status " + std::to_string(code) +
           (code > 128 ? " (signal " + std::to_string(code - 128) + "?)" : "");
  }

 private:
  static constexpr std::chrono::microseconds longest_pause{10'000};
  std::optional<TemporaryFolder> temporary_;  ///< of an isolated one
  std::string name_;
  ProcessGroup group_;
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
      tell_fate(error.code());
    }
  }
  [[noreturn]] void tell_fate(ErrorCode otherwise) {
    const std::string fate = program_.fate();
    throw Error(program_.has_faulted() ? ErrorCode::internal : otherwise, fate);
  }

 public:
  SpawnedChannel(const ProgramStart& start, const SocketSettings& settings)
      : peer_(start.address), program_(start, our_end_) {
    channel_ = adopt(our_end_.release(), peer_, settings);
  }

  void send(std::span<const std::byte> frame, wire::Deadline deadline) override {
    told([&] { channel_->send(frame, deadline); });
  }
  std::span<const std::byte> receive(wire::Deadline deadline) override {
    const auto frame = told([&] { return channel_->receive(deadline); });
    if (frame.empty()) tell_fate(ErrorCode::input_output);
    return frame;
  }
  void forget() override { channel_->forget(); }
  bool wait(wire::Deadline deadline) override { return channel_->wait(deadline); }
  void close() noexcept override { channel_->close(); }
  const std::string& peer() const override { return peer_; }

 private:
  std::string peer_;
  Descriptor our_end_;
  Program program_;
  std::unique_ptr<wire::Channel> channel_;  // goes before the program, which ends when its socket is closed
};

}  // namespace
}  // namespace tcp

std::unique_ptr<wire::Channel> spawn(const ProgramStart& start, const SocketSettings& settings) {
  return std::make_unique<tcp::SpawnedChannel>(start, settings);
}

}  // namespace tandem
