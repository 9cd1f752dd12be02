// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "scratch.hpp"

namespace tandem::test {

struct Said {
  int status;  ///< of exit; -1 if a signal ended it
  std::string out, err;
};

inline std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Runs `tandem` with these arguments in `folder`.
inline Said tandem(const Scratch& folder, const std::vector<std::string>& arguments,
                   const std::string& program = TANDEM_COMMAND) {
  const std::string out = (folder.path() / "out.txt").string(), err = (folder.path() / "err.txt").string();
  std::string line = "cd " + shell_quoted(folder.path().string()) + " && " + shell_quoted(program);
  for (const std::string& argument : arguments) line += " " + shell_quoted(argument);
  const int status = std::system((line + " >" + shell_quoted(out) + " 2>" + shell_quoted(err)).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
}

inline std::string two_mass_file(const std::string& name) {
  return std::string(TANDEM_SOURCE_DIR) + "/scenarios/two_mass/" + name;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace tandem::test
