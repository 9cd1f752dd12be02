// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <csignal>
#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/say.hpp"
#include "cli/transports.hpp"
#include "cli/validators.hpp"
#include "tandem/error.hpp"
#include "tandem/library_file.hpp"
#include "tandem/output/provenance.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/tcp/tcp.hpp"

namespace tandem::cli {
namespace {

struct ServeOptions {
  std::string source, address;
  wire::ServerSettings server;
  double spin = 50.0;  ///< microseconds
  ServerKeys keys;
};

/// A subsystem for each session, with the parameters that its client gave.
wire::MakeSubsystem maker(const std::string& source, const Context& context) {
  return [source, &context](const std::string& parameters) {
    Opening opening;
    if (!parameters.empty()) opening.parameters.read(parameters, "the client", Setter::client);
    return open(source, context.builtins, std::move(opening));
  };
}

/// The one session of a program that a run has started.
void serve_parent(const std::string& number, const ServeOptions& options, const SocketSettings& socket,
                  const Context& context) {
  int descriptor = -1;
  const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), descriptor);
  if (code != std::errc{} || *end != '\0' || descriptor < 0)
    throw Error(ErrorCode::invalid_argument,
                "the variable TANDEM_FD is '" + number + "'; allowed is the number of a socket that is open");
  LibraryCall::return_from_faults();  // the client is told, as the library's user
  LibraryCall::set_told_by_parent(true);
  const auto channel = adopt(descriptor, "the program that started this one", socket);
  bool failed = false;
  {
    wire::Session session(*channel, maker(options.source, context), options.server.session);
    try {
      session.serve();
      failed = LibraryCall::has_faulted();
    } catch (const Error&) {
      failed = true;
    }
    LibraryCall::set_told_by_parent(false);  // who has closed its session waits no more
  }
  if (failed) throw CLI::RuntimeError(1);  // whoever has started this program is told, and tells it
}

/// Whether a sentence names a parameter of the source, or its value: a client can't give it anew.
bool is_about_own(const std::string& sentence, const std::string& source) {
  Parameters own = query_of(source);
  const auto names = own.names("");
  return std::ranges::any_of(names, [&](const std::string& name) {
    return sentence.find("'" + name + "'") != std::string::npos ||
           sentence.find("'" + own.text(name, "") + "'") != std::string::npos;
  });
}

/// Whether a sentence has a word in it that the operator alone may set.
bool is_about_operators(const std::string& sentence, const Words& words) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return std::ranges::any_of(words, [&](const Word& word) {
    const auto at = sentence.find(word.name), end = at + word.name.size();
    return word.setter == Setter::operator_only && at != std::string::npos &&
           !(at > 0 && is_letter(sentence[at - 1])) && !(end < sentence.size() && is_letter(sentence[end]));
  });
}

/// Of its files, which a client may set.
bool has_parameters(const std::string& source) try {
  Parameters given = query_of(source);
  return !scenario::parameters_of(source, {}, {}, given).empty();
} catch (const Error&) {
  return false;
}

/// What no parameter of a client mends is refused at once, not when the first session begins. Otherwise the error is
/// only told.
void try_source(const std::string& source, const Context& context) {
  source_of(source, context.builtins);
  try {
    open(source, context.builtins);
  } catch (const Error& error) {
    const Source& made_by = source_of(source, context.builtins);
    const bool lacks = made_by.code || made_by.elsewhere || has_parameters(source) ||
                       std::string(error.what()).find("parameter step") != std::string::npos;
    if (error.code() == ErrorCode::input_output || !lacks || is_about_own(error.what(), source) ||
        (made_by.native && is_about_operators(error.what(), made_by.words)))
      throw;
    spdlog::warn(
        "opened without a client's parameters this source has an error: {}; each session opens "
        "it anew, with those of its client",
        error.what());
  }
}

/// The memory of a large request or reply goes back to the system when it is freed; glibc would keep blocks
/// of up to 32 MiB once it has seen one go.
void return_large_blocks() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

void serve(ServeOptions options, const Context& context) {
  return_large_blocks();
  SocketSettings socket{options.server.session.deadline, 1e-6 * options.spin, context.allow_plaintext};
  options.server.session.software = "tandem " + output::version();
  const char* descriptor = std::getenv("TANDEM_FD");
  if (options.address.empty() && descriptor) return serve_parent(descriptor, options, socket, context);
  if (options.address.empty())
    throw Error(ErrorCode::invalid_argument,
                "--listen is needed: tcp://HOST:PORT (port 0: a free one), tls://HOST:PORT, unix:PATH or "
                "zmq:ADDRESS");
  const InterruptGuard guard;
  std::signal(SIGPIPE,
              [](int) {});  // who reads the log may be gone; programs that are started have it as ever
  try_source(options.source, context);
  auto listener = listener_at(options.address, socket, options.keys);
  options.server.overdue = [&](int sessions) {
    spdlog::warn("{} session{} still computing {} s after the end was asked for, and end{} with the server",
                 sessions, sessions == 1 ? " is" : "s are", options.server.session.deadline,
                 sessions == 1 ? "s" : "");
    listener.reset();
    LibraryCall::end_program(1);
    std::_Exit(1);
  };
  options.server.log = [](const std::string& sentence) { spdlog::info("{}", sentence); };
  say("serving {} at {}\n", options.source, listener->address());
  if (std::fflush(stdout) != 0)
    throw RunFailed("standard output can't be written, so nobody knows the address");
  wire::Server(*listener, maker(options.source, context), options.server).run(InterruptGuard::interrupted);
}

}  // namespace

void add_serve(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("serve", "Serve a source to other processes, until Ctrl-C or SIGTERM");
  auto options = std::make_shared<ServeOptions>();
  command->add_option("source", options->source, "What each session gets an instance of: builtin:NAME, ...")
      ->required()
      ->type_name("SOURCE");
  command
      ->add_option(
          "--listen", options->address,
          "Where: tcp://HOST:PORT (port 0: a free one, which is printed), tls://HOST:PORT, unix:PATH, "
          "zmq:ADDRESS")
      ->type_name("URI");
  command->add_option("--sessions", options->server.most_sessions, "The most sessions at a time")
      ->check(from_to(1, 10000))
      ->capture_default_str();
  command->add_flag("--once", options->server.once, "End after one session, of a client that has said hello");
  command->add_option("--idle", options->server.session.idle, "Seconds from one request to the next")
      ->check(positive)
      ->capture_default_str();
  command
      ->add_option("--deadline", options->server.session.deadline,
                   "Seconds for a request to come whole, and for a reply to be taken")
      ->check(positive)
      ->capture_default_str();
  command
      ->add_option(
          "--spin", options->spin,
          "Microseconds to look at the socket without a pause before sleeping; ZeroMQ sleeps at once")
      ->check(not_negative)
      ->capture_default_str();
  command
      ->add_option("--key", options->keys.own,
                   "The secret key of a zmq: server (its public one is FILE.pub) or of a tls: server (its "
                   "certificate is FILE with .crt for its extension)")
      ->type_name("FILE");
  command
      ->add_option("--authority", options->keys.authority,
                   "The certificate that those of the clients of tls: are signed by")
      ->type_name("FILE");
  command
      ->add_option("--client-key", options->keys.clients,
                   "The public key of a client that zmq: lets in (repeatable)")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
  command->footer(
      "Parameters come from the client: tcp://HOST:PORT?frequency_ratio=25. A program that a run has started "
      "needs no --listen.\n"
      "Ctrl-C and SIGTERM close the sessions; one that still computes after --deadline ends with the server, "
      "a "
      "second signal ends all at once.\n"
      "Exit status: 0 when it was ended; 1 if a session was computing then; 2 for a source that is not "
      "there, and "
      "an address or option that is not right.");
  command->callback([options, &context] { serve(*options, context); });
}

}  // namespace tandem::cli
