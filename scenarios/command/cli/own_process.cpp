// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/own_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "cli/commands.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

/// The last line of one that came to its end: a library may end it with any status.
constexpr const char* to_the_end = "to the end";

/// The last line, once the other end is closed.
std::string last_line(int pipe) {
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = ::read(pipe, part.data(), part.size())) != 0;) {
    if (count > 0) text.append(part.data(), static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  ::close(pipe);
  if (!text.empty()) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

/// Ends this process as the child has ended.
void follow(pid_t child, const std::string& last) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && last != to_the_end)
    throw RunFailed("the process was ended (status 0) at: " + last);
  if (!WIFSIGNALED(status)) std::exit(WEXITSTATUS(status));
  throw RunFailed(fmt::format("signal {} ({}) ended the process at: {}", WTERMSIG(status),
                              ::strsignal(WTERMSIG(status)), last));
}

}  // namespace

void in_own_process(const std::function<void(const Tell&)>& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(ErrorCode::input_output, std::string("no pipe: ") + std::strerror(errno));
  static_cast<void>(std::fflush(nullptr));
  const pid_t child = ::fork();
  if (child == 0) {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    const auto tell = [to = ends[1]](const std::string& what) {
      const std::string line = what + "\n";
      static_cast<void>(!::write(to, line.data(), line.size()));
    };
    work(tell);
    return tell(to_the_end);
  }
  ::close(ends[1]);
  if (child < 0) throw Error(ErrorCode::input_output, std::string("no process: ") + std::strerror(errno));
  follow(child, last_line(ends[0]));
}

}  // namespace tandem::cli
