// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <set>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/limited_memory.hpp"
#include "cli/log.hpp"
#include "sources/all.hpp"
#include "sources/this_program.hpp"
#include "tandem/coordinator/bounds.hpp"
#include "tandem/error.hpp"
#include "tandem/library_file.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output/provenance.hpp"
#include "tandem/printable.hpp"

namespace {

std::vector<std::string> commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string command_of(const CLI::App& app) {
  const auto used = app.get_subcommands();
  return used.empty() ? "tandem" : "tandem " + used.front()->get_name();
}

/// Sentences that were told: subsystems are built again and again. Any thread may call it.
class Told {
 public:
  bool is_new(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    if (all_.size() == most) all_.clear();  // a server's clients may bring about more and more
    return all_.insert(sentence).second;
  }

 private:
  static constexpr std::size_t most = 1000;
  std::mutex mutex_;
  std::set<std::string> all_;
};

tandem::Builtins sources(const tandem::cli::Context& context) {
  tandem::Builtins all = tandem::all_sources(
      {context.allow_plaintext, [told = std::make_shared<Told>()](const std::string& what) {
         if (told->is_new(what)) spdlog::warn("{}", what);
       }});
  if (const std::string own = tandem::this_program(); !own.empty())
    all.server = context.quiet ? std::vector<std::string>{own, "--quiet", "serve"}
                               : std::vector<std::string>{own, "serve"};
  return all;
}

int run(int argc, char** argv) {
  CLI::App app{"tandem: multirate co-simulation", "tandem"};
  app.set_version_flag("--version", tandem::output::version());
  app.require_subcommand(1);
  app.fallthrough();
  tandem::cli::Context context;
  std::string log_file;
  auto* quiet = app.add_flag("--quiet", context.quiet, "Print results and errors only");
  app.add_flag("--verbose", context.verbose, "Print more of what is done")->excludes(quiet);
  app.add_option("--log", log_file, "Write all messages to this file too")->type_name("FILE");
  app.add_flag("--allow-plaintext", context.allow_plaintext,
               "Let tcp:// and zmq: without keys go beyond this machine, in plain text");
  app.parse_complete_callback([&] {
    tandem::cli::set_up_log(context, log_file);
    context.builtins = sources(context);
  });
  tandem::cli::add_run(app, context);
  tandem::cli::add_sweep(app, context);
  tandem::cli::add_chart(app, context);
  tandem::cli::add_compare(app, context);
  tandem::cli::add_info(app, context);
  tandem::cli::add_validate(app, context);
  tandem::cli::add_check(app, context);
  tandem::cli::add_modes(app, context);
  tandem::cli::add_stability(app, context);
  tandem::cli::add_advise(app, context);
  tandem::cli::add_list(app, context);
  tandem::cli::add_serve(app, context);
  tandem::cli::add_keys(app, context);
  tandem::cli::add_bench(app, context);
  tandem::cli::add_view(app, context);
  tandem::cli::add_ladder(app, context);
  tandem::cli::add_export(app, context);
  tandem::cli::add_help(app, context);
  tandem::cli::add_schema(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    const auto rest = app.remaining();
    if (app.get_subcommands().empty() && !rest.empty() && !rest[0].starts_with('-'))
      throw tandem::Error(tandem::ErrorCode::invalid_argument,
                          tandem::unknown("command", rest[0], commands(app)));
    if (error.get_name() == "RuntimeError") return 2;  // it is told
    spdlog::error("{}; {} --help tells what is allowed", error.what(), command_of(app));
    return 2;
  }
  return 0;
}

/// What the command is about: "compare a b".
std::string first_words(int argc, char** argv) {
  std::string all;
  for (int k = 1; k < std::min(argc, 4); ++k) all += (k > 1 ? " " : "") + std::string(argv[k]);
  return all;
}

}  // namespace

int run_and_report(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const tandem::cli::RunFailed& failure) {
    spdlog::error("{}", failure.what());
    return 1;
  } catch (const tandem::NoRoom& full) {
    spdlog::error("{}", full.what());
    return 1;
  } catch (const tandem::Diverged& diverged) {
    spdlog::error("{}", diverged.what());
    return 1;
  } catch (const std::filesystem::filesystem_error& error) {
    spdlog::error("'{}': {}", error.path1().string(), error.code().message());
    return 2;
  } catch (const std::bad_alloc& shortage) {
    spdlog::error("{}: {}", tandem::printable(first_words(argc, argv)), tandem::sentence_of(shortage));
    return 1;
  } catch (const tandem::Error& error) {
    spdlog::error("{}", error.what());
    return error.code() == tandem::ErrorCode::internal || tandem::LibraryCall::has_faulted() ? 1 : 2;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return tandem::LibraryCall::has_faulted() ? 1 : 2;
  }
}

std::atomic<bool> memory_was_short = false;

/// A library may throw where nothing can be caught: nlohmann-json allocates as it frees, toml++ in functions
/// that say they don't throw. What was thrown there is not always to be had.
[[noreturn]] void end_for_want_of_memory() {
  bool short_of_memory = memory_was_short;
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    short_of_memory = true;
  } catch (...) {  // a mistake of the program's
    short_of_memory = false;
  }
  if (!short_of_memory) std::abort();
  std::fputs("tandem: there is no memory for it\n", stderr);
  tandem::LibraryCall::end_program(1);
  std::_Exit(1);
}

/// Whoever starts the command without its standard streams would find what it writes there in the next file
/// that it opens.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDWR);
}

/// On a full disk, say.
bool wrote_all_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  spdlog::error("standard output can't be written, so not all was told");
  return false;
}

int main(int argc, char** argv) {
  tandem::cli::begin_anew_if_limited(argv);
  open_standard_streams();
  std::set_new_handler([] {
    memory_was_short = true;
    throw std::bad_alloc();
  });
  std::set_terminate(end_for_want_of_memory);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of the size of files is told as a full disk is
  try {
    tandem::cli::set_up_log({}, "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem: %s\n", tandem::sentence_of(error).c_str());
    return 1;
  }
  tandem::LibraryCall::begin_program();
  int status = run_and_report(argc, argv);
  if (status == 0 && !wrote_all_output()) status = 1;
  spdlog::default_logger()->flush();
  if (status == 0 && tandem::cli::has_log_failed()) status = 1;
  const bool faulted = tandem::LibraryCall::has_faulted();
  if (faulted && status == 0)
    spdlog::error("a library made a fault at its end, after all that was told"), status = 1;
  if (tandem::LibraryCall::was_bad_end() && status == 0)
    spdlog::error("an isolated library's process did not end well, after all that was told"), status = 1;
  tandem::LibraryCall::end_program(status);
  if (faulted) std::_Exit(status);  // unloads none
  return status;
}
