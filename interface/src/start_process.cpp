// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/start_process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "tandem/error.hpp"

extern char** environ;  // NOLINT: POSIX gives it no header

namespace tandem {
namespace {

/// What the new process does before the program starts.
class Setting {
 public:
  explicit Setting(const ProcessStart& start) {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    if (!start.folder.empty()) posix_spawn_file_actions_addchdir_np(&files_, start.folder.c_str());
    for (const auto& [from, to] : {std::pair{start.input, STDIN_FILENO},
                                   {start.output, STDOUT_FILENO},
                                   {start.error, STDERR_FILENO},
                                   {start.kept, start.kept}})
      if (from >= 0) posix_spawn_file_actions_adddup2(&files_, from, to);
    if (start.group < 0) return;
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, start.group);
  }
  ~Setting() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

  int start(pid_t& process, char* const* words, char* const* variables) const {
    return posix_spawnp(&process, words[0], &files_, &attributes_, words, variables);
  }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

/// As exec takes them: pointers to each, and null.
std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

bool sets(const std::string& variable, std::string_view other) {
  return other.starts_with(std::string_view(variable).substr(0, variable.find('=') + 1));
}

std::vector<std::string> variables_of(const ProcessStart& start) {
  std::vector<std::string> all = start.variables;
  for (char** other = environ; *other; ++other) {
    bool given = false;
    for (const std::string& one : start.variables) given = given || sets(one, *other);
    if (!given) all.emplace_back(*other);
  }
  return all;
}

}  // namespace

pid_t start_process(const ProcessStart& start) {
  const std::vector<std::string> variables = variables_of(start);
  pid_t process = -1;
  const int failed = Setting(start).start(process, pointers(start.words).data(), pointers(variables).data());
  if (failed == 0) return process;
  const std::string name = start.name.empty() ? "'" + start.words[0] + "'" : start.name;
  throw Error(ErrorCode::input_output, "program " + name + " can't be started: " + std::strerror(failed));
}

int end_of_process(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

}  // namespace tandem
