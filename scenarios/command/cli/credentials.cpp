// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/say.hpp"
#include "cli/validators.hpp"
#include "tandem/error.hpp"
#include "tandem/tcp/certificates.hpp"
#if TANDEM_HAS_ZEROMQ
#include "tandem/zeromq/zeromq.hpp"
#endif

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct KeysOptions {
  std::string folder = "keys";
  double days = 365.0;  ///< that certificates are valid
};

struct KeyFile {
  std::string name, text;
  bool secret;
};

[[noreturn]] void refuse_key(const fs::path& file, const std::string& why) {
  throw Error(ErrorCode::input_output, "key file '" + file.string() + "' can't be written: " + why);
}

/// A file that was not there before, and that nobody else may read if it is secret, at no time.
void write_new(const fs::path& folder, const KeyFile& key) {
  const fs::path file = folder / key.name;
  const int descriptor =
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, key.secret ? 0600 : 0644);
  if (descriptor < 0)
    refuse_key(file, errno == ENOENT   ? "there is no such folder, and it can't be made"
                     : errno == EEXIST ? "it is there; allowed is a file that is not there yet"
                                       : std::strerror(errno));
  const ssize_t written = ::write(descriptor, key.text.data(), key.text.size());
  const int why = errno;
  ::close(descriptor);
  if (written == static_cast<ssize_t>(key.text.size())) return;
  ::unlink(file.c_str());
  if (written < 0 && why != ENOSPC) refuse_key(file, std::strerror(why));
  throw NoRoom("key file '" + file.string() + "' can't be written: the disk is full");
}

#if TANDEM_HAS_ZEROMQ
std::vector<KeyFile> curve_files() {
  std::vector<KeyFile> files;
  for (const std::string name : {"server", "client"}) {
    const CurveKeys keys = make_curve_keys();
    files.push_back({name, keys.secret_key + "\n", true});
    files.push_back({name + ".pub", keys.public_key + "\n", false});
  }
  return files;
}
#endif

std::vector<KeyFile> tls_files(double days) {
  const TlsPair pair = make_tls_pair(86400.0 * days);
  return {{"server.key", pair.server.key, true},
          {"server.crt", pair.server.certificate, false},
          {"client.key", pair.client.key, true},
          {"client.crt", pair.client.certificate, false},
          {"authority.crt", pair.authority, false}};
}

/// Files of one kind, and how to use them.
void write_kind(const fs::path& folder, const std::vector<KeyFile>& files, const std::string& use) {
  std::string names;
  for (const KeyFile& file : files) {
    write_new(folder, file);
    names += (names.empty() ? "" : ", ") + (folder / file.name).string();
  }
  say("wrote {}\n{}", names, use);
}

void make_keys(const KeysOptions& options) {
  if (constexpr double most = 36500.0; options.days > most)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--days is {}; allowed is a number up to {}", options.days, most));
  std::error_code code;
  fs::create_directories(options.folder, code);
  if (has_tls())
    write_kind(options.folder, tls_files(options.days),
               "take server.key, server.crt, authority.crt to the one machine, client.key, client.crt, "
               "authority.crt to the other:\n"
               "  tandem serve SOURCE --listen tls://HOST:PORT --key server.key --authority authority.crt\n"
               "  tls://HOST:PORT?key=client.key&authority=authority.crt\n");
  else
    say("no certificates: this build has no TLS (package libssl-dev)\n");
#if TANDEM_HAS_ZEROMQ
  write_kind(options.folder, curve_files(),
             "take server and client.pub to the one machine, client and server.pub to the other:\n"
             "  tandem serve SOURCE --listen zmq:tcp://HOST:PORT --key server --client-key client.pub\n"
             "  zmq:tcp://HOST:PORT?key=client&server_key=server.pub\n");
#else
  say("no CURVE keys: this build has no ZeroMQ (packages cppzmq-dev, libzmq3-dev)\n");
#endif
}

}  // namespace

void add_keys(CLI::App& app, Context&) {
  auto* command = app.add_subcommand(
      "keys", "Make what a pair of machines needs: certificates for tls:, CURVE keys for zmq:");
  auto options = std::make_shared<KeysOptions>();
  command->add_option("folder", options->folder, "Where to put them; nothing is overwritten")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--days", options->days, "How long the certificates are valid, up to a whole second")
      ->check(positive)
      ->capture_default_str();
  command->callback([options] { make_keys(*options); });
}

}  // namespace tandem::cli
