// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/process_group.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tandem/error.hpp"

namespace tandem {

void fail_to_start(const std::string& program, const char* what) {
  throw Error(ErrorCode::input_output,
              "program " + program + " can't be started: " + what + ": " + std::strerror(errno));
}

ProcessGroup::ProcessGroup(const std::string& program) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) fail_to_start(program, "pipe");
  number_ = ::fork();
  if (number_ == 0) {
    ::setpgid(0, 0);
    ::dup2(ends[0], STDIN_FILENO);
    ::fcntl(STDIN_FILENO, F_SETFD, 0);
    ::execl("/bin/sh", "sh", "-c", "trap '' HUP INT TERM; read x; kill -KILL 0", nullptr);
    ::_exit(127);
  }
  ::close(ends[0]);
  held_open_ = ends[1];
  if (number_ > 0) {
    ::setpgid(number_, number_);  // here too: whoever joins may come before the shell
    return;
  }
  ::close(held_open_);
  fail_to_start(program, "fork");
}

/// The shell is not waited for until the group is killed, so that nobody else has its number.
ProcessGroup::~ProcessGroup() {
  signal(SIGKILL);
  ::close(held_open_);
  while (::waitpid(number_, nullptr, 0) < 0 && errno == EINTR) continue;
}

void ProcessGroup::signal(int number) const noexcept { ::kill(-number_, number); }

}  // namespace tandem
