// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tandem/error.hpp"

extern char** environ;  // NOLINT: POSIX gives it no header

namespace tandem::charts {
namespace {

/// What the new process does before the program starts: it goes to the folder, its standard input is empty
/// and its standard error goes into the pipe.
class Setting {
 public:
  Setting(const std::filesystem::path& folder, const int (&pipe)[2]) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, pipe[1], STDERR_FILENO);
  }
  ~Setting() { posix_spawn_file_actions_destroy(&actions_); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

std::string read_all(int descriptor) {
  std::string text;
  char part[4096];
  for (ssize_t count = 0; (count = read(descriptor, part, sizeof part)) != 0;) {
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  close(descriptor);
  return text;
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \n\r\t") + 1);
  return text.substr(text.rfind('\n') + 1);  // rfind gives npos, and npos + 1 is 0
}

std::vector<char*> arguments(const std::vector<std::string>& words) {
  std::vector<char*> pointers(words.size() + 1, nullptr);  // ends with a null pointer
  for (std::size_t k = 0; k < words.size(); ++k) pointers[k] = const_cast<char*>(words[k].c_str());
  return pointers;
}

}  // namespace

void run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 const std::string& where) {
  if (!std::filesystem::is_directory(folder))
    throw Error(ErrorCode::input_output, "'" + folder.string() + "' is no folder");
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC) != 0)
    throw Error(ErrorCode::internal, std::string("no pipe: ") + std::strerror(errno));
  const Setting setting(folder, pipe);
  pid_t process = 0;
  const int failure =
      posix_spawnp(&process, words[0].c_str(), setting.get(), nullptr, arguments(words).data(), environ);
  close(pipe[1]);
  const std::string messages = read_all(pipe[0]);
  if (failure != 0)
    throw Error(ErrorCode::not_supported,
                "program '" + words[0] + "' (" + where + ") can't be started: " + std::strerror(failure));
  const int status = wait_for(process);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(ErrorCode::internal, "program '" + words[0] + "' failed: " + last_line(messages));
}

}  // namespace tandem::charts
