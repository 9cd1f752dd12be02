// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <stdexcept>

#include "tandem/transports/open.hpp"

namespace tandem::cli {

/// A run that began and failed: exit status 1. Any tandem::Error that leaves a command means status 2.
class RunFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What every command knows.
struct Context {
  bool quiet = false;  ///< results and errors only
  bool verbose = false;
  bool allow_plaintext = false;  ///< also beyond the loopback interface
  Builtins builtins;             ///< what "builtin:NAME" can name
};

// Each adds one subcommand to the app; `context` outlives the parsing. The work is done in the subcommand's
// callback.
void add_run(CLI::App& app, Context& context);
void add_validate(CLI::App& app, Context& context);
void add_check(CLI::App& app, Context& context);
void add_info(CLI::App& app, Context& context);
void add_modes(CLI::App& app, Context& context);
void add_stability(CLI::App& app, Context& context);
void add_advise(CLI::App& app, Context& context);
void add_list(CLI::App& app, Context& context);
void add_compare(CLI::App& app, Context& context);
void add_sweep(CLI::App& app, Context& context);
void add_chart(CLI::App& app, Context& context);
void add_keys(CLI::App& app, Context& context);
void add_serve(CLI::App& app, Context& context);
void add_bench(CLI::App& app, Context& context);
void add_view(CLI::App& app, Context& context);
void add_ladder(CLI::App& app, Context& context);
void add_export(CLI::App& app, Context& context);
void add_help(CLI::App& app, Context& context);
void add_schema(CLI::App& app, Context& context);

}  // namespace tandem::cli
