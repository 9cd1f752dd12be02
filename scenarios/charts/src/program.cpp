// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tandem/error.hpp"
#include "tandem/start_process.hpp"

namespace tandem::charts {
namespace {

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

std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \n\r\t") + 1);
  return text.substr(text.rfind('\n') + 1);  // rfind gives npos, and npos + 1 is 0
}

/// Its standard input is empty.
pid_t started(const std::vector<std::string>& words, const std::filesystem::path& folder,
              const std::string& where, int error) {
  const int none = open("/dev/null", O_RDONLY | O_CLOEXEC);
  try {
    const pid_t process = start_process({.words = words,
                                         .input = none,
                                         .error = error,
                                         .folder = folder,
                                         .name = "'" + words[0] + "' (" + where + ")"});
    close(none), close(error);
    return process;
  } catch (const Error& failure) {
    close(none), close(error);
    throw Error(ErrorCode::not_supported, failure.what());
  }
}

}  // namespace

void run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 const std::string& where) {
  if (!std::filesystem::is_directory(folder))
    throw Error(ErrorCode::input_output, "'" + folder.string() + "' is no folder");
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC) != 0)
    throw Error(ErrorCode::internal, std::string("no pipe: ") + std::strerror(errno));
  pid_t process = -1;
  try {
    process = started(words, folder, where, pipe[1]);
  } catch (const Error&) {
    close(pipe[0]);
    throw;
  }
  const std::string messages = read_all(pipe[0]);
  const int status = end_of_process(process);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(ErrorCode::internal, "program '" + words[0] + "' failed: " + last_line(messages));
}

}  // namespace tandem::charts
