// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tandem::test {

/// Another process, whose standard output is read here. It is killed with its owner.
class Child {
 public:
  explicit Child(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::execvp(arguments[0], arguments.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    out_ = ends[0];
  }
  ~Child() {
    if (process_ > 0) ::kill(process_, SIGKILL), status();
    ::close(out_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t process() const { return process_; }
  void signal(int number) const { ::kill(process_, number); }

  /// Waits for its end: its exit status, or the negative number of the signal that ended it.
  int status() {
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  /// Reads its output until a line holds `mark`, and gives the word that follows it there.
  std::string word_after(const std::string& mark) {
    std::string line;
    for (char c; ::read(out_, &c, 1) == 1;) {
      if (c != '\n') {
        line += c;
        continue;
      }
      if (const auto at = line.find(mark); at != std::string::npos) {
        const auto begin = at + mark.size();
        return line.substr(begin, line.find(' ', begin) - begin);
      }
      line.clear();
    }
    throw std::runtime_error("the output ended without '" + mark + "'");
  }

 private:
  pid_t process_ = -1;
  int out_ = -1;
};

/// It has ended, though perhaps nobody has asked for its status yet.
inline bool is_gone(pid_t process) {
  if (::kill(process, 0) != 0) return true;
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return stat >> number >> name >> state && (state == "Z" || state == "X");
}

/// It ends within 5 s. (For a process that is nobody's child here.)
inline bool ends(pid_t process) {
  for (int k = 0; k < 5000 && !is_gone(process); ++k) ::usleep(1000);
  return is_gone(process);
}

}  // namespace tandem::test
