// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/commands.hpp"
#include "sources/this_program.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

/// Becomes the program of benchmarks; returns only by what it throws.
void become(std::vector<std::string> words) {
  const std::string program = program_beside("tandem_bench");
  if (program.empty())
    throw Error(
        ErrorCode::not_supported,
        "the benchmarks are a program of their own, tandem_bench, which is not beside this one; "
        "'cmake --preset release' and 'cmake --build --preset release --target tandem_bench' build it "
        "in the source tree");
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  throw Error(ErrorCode::input_output, program + " does not start: " + std::strerror(errno));
}

}  // namespace

void add_bench(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand(
      "bench", "Time a part of tandem beside what else does the same: the program tandem_bench");
  command->allow_extras()->fallthrough(false)->set_help_flag();
  command->callback([command, &context] {
    std::vector<std::string> words = command->remaining();
    if (context.quiet) words.emplace_back("--quiet");
    become(std::move(words));
  });
}

}  // namespace tandem::cli
