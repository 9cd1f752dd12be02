// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/start_process.hpp"

namespace tandem::mbs {
namespace {

[[noreturn]] void refuse(const std::string& program, int number) {
  throw Error(ErrorCode::input_output,
              "program '" + program + "' can't be started: " + std::strerror(number));
}

}  // namespace

/// A pair of sockets and not two pipes, since a pipe that nobody reads any more ends who writes to it.
Process::Process(std::vector<std::string> command) : group_("'" + command[0] + "'") {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse(command[0], errno);
  try {
    child_ = start_process(
        {.words = command, .input = ends[1], .output = ends[1], .error = ends[1], .group = group_.number()});
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[1]);
  socket_ = ends[0];
  fcntl(socket_, F_SETFL, O_NONBLOCK);
}

Process::~Process() {
  end();
  close(socket_);
}

bool Process::wait_for(short events, Instant deadline) const {
  using namespace std::chrono;
  pollfd p{socket_, events, 0};
  for (;;) {
    const auto left = ceil<milliseconds>(deadline - steady_clock::now()).count();
    const int ready = poll(&p, 1, static_cast<int>(std::clamp<long long>(left, 0, 1000000000)));
    if (ready != 0 && !(ready < 0 && errno == EINTR)) return true;
    if (left <= 0) return false;
  }
}

Process::Outcome Process::write(std::string_view text, Instant deadline) {
  while (!text.empty()) {
    const ssize_t sent = send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
    if (sent > 0)
      text.remove_prefix(static_cast<std::size_t>(sent));
    else if (errno != EAGAIN && errno != EINTR)
      return Outcome::ended;
    else if (!wait_for(POLLOUT, deadline))
      return Outcome::late;
  }
  return Outcome::ok;
}

Process::Outcome Process::read_line(std::string& line, Instant deadline) {
  for (std::size_t searched = 0;;) {
    const auto end = received_.find('\n', searched);
    if (end != std::string::npos) {
      line.assign(received_, 0, end);
      received_.erase(0, end + 1);
      return Outcome::ok;
    }
    searched = received_.size();
    std::array<char, 4096> piece;
    const ssize_t count = recv(socket_, piece.data(), piece.size(), 0);
    if (count > 0) {
      received_.append(piece.data(), static_cast<std::size_t>(count));
    } else if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
      if (!wait_for(POLLIN, deadline)) return Outcome::late;
    } else if (received_.empty()) {
      return Outcome::ended;
    } else {
      line = std::exchange(received_, {});
      return Outcome::ok;
    }
  }
}

std::string Process::end() {
  if (child_ > 0) {
    int status = 0;
    if (waitpid(child_, &status, WNOHANG) == 0) {
      kill(child_, SIGKILL);
      status = end_of_process(child_);
    }
    child_ = -1;
    how_it_ended_ = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                        : "exit status " + std::to_string(WEXITSTATUS(status));
  }
  return how_it_ended_;
}

}  // namespace tandem::mbs
