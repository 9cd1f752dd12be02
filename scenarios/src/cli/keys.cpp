// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#if TANDEM_HAS_ZEROMQ
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "tandem/error.hpp"
#include "tandem/zeromq/zeromq.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

/// A file that was not there before, and that nobody else may read if `secret`, at no time.
void write_new(const fs::path& file, const std::string& key, bool secret) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, secret ? 0600 : 0644);
  const std::string line = key + "\n";
  const bool written =
      descriptor >= 0 && ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  if (descriptor >= 0) ::close(descriptor);
  if (!written)
    throw Error(ErrorCode::input_output,
                "key file '" + file.string() + "' can't be written; allowed is a file that is not there yet");
}

void make_keys(const std::string& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  for (const std::string name : {"server", "client"}) {
    const CurveKeys keys = make_curve_keys();
    write_new(fs::path(folder) / name, keys.secret_key, true);
    write_new(fs::path(folder) / (name + ".pub"), keys.public_key, false);
  }
  fmt::print(
      "wrote {0}/server, {0}/server.pub, {0}/client, {0}/client.pub\n"
      "take server and client.pub to the one machine, client and server.pub to the other:\n"
      "  tandem serve SOURCE --listen zmq:tcp://HOST:PORT --key server --client-key client.pub\n"
      "  zmq:tcp://HOST:PORT?key=client&server_key=server.pub\n",
      folder);
}

}  // namespace

void add_keys(CLI::App& app, Context&) {
  auto* command = app.add_subcommand("keys", "Make the CURVE keys of a pair of machines, for zmq:");
  auto folder = std::make_shared<std::string>("keys");
  command->add_option("folder", *folder, "Where to put them; nothing is overwritten")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback([folder] { make_keys(*folder); });
}

}  // namespace tandem::cli
#endif
