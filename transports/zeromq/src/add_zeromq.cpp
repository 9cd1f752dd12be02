// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <sstream>
#include <zmq.hpp>

#include "tandem/error.hpp"
#include "tandem/transports/key_file.hpp"
#include "tandem/wire/remote_subsystem.hpp"
#include "tandem/zeromq/zeromq.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;

ZmqSettings settings_from(const Address& address, Parameters& p, bool allow_plaintext) {
  ZmqSettings s;
  s.deadline = positive(p, "deadline", s.deadline);
  s.allow_plaintext = allow_plaintext;
  const std::string key = p.text("key", ""), server_key = p.text("server_key", "");
  if (key.empty() != server_key.empty())
    throw Error(ErrorCode::invalid_argument,
                "source '" + address.uri + "' has one of key and server_key; allowed are both or none");
  if (key.empty()) return s;
  s.keys = {read_curve_key(address.folder / (key + ".pub"), false),
            read_curve_key(address.folder / key, true)};
  s.server_key = read_curve_key(address.folder / server_key, false);
  return s;
}

/// Paths are seen from the folder of the scenario; "@NAME" is none.
std::string in_folder(const Address& address) {
  const std::string scheme = "ipc://";
  if (!address.place.starts_with(scheme) || address.place.starts_with(scheme + "@") ||
      address.place == scheme)
    return address.place;
  return scheme + (address.folder / address.place.substr(scheme.size())).string();
}

}  // namespace

CurveKeys make_curve_keys() {
  std::array<char, 41> open_key{}, secret_key{};
  if (::zmq_curve_keypair(open_key.data(), secret_key.data()) != 0)
    throw Error(ErrorCode::not_supported, "this ZeroMQ was built without CURVE");
  return {open_key.data(), secret_key.data()};
}

std::string read_curve_key(const fs::path& file, bool secret) {
  std::string key;
  std::istringstream(read_key_file(file, secret)) >> key;
  std::array<std::uint8_t, 32> bytes{};
  if (key.size() != 40 || !::zmq_z85_decode(bytes.data(), key.c_str()))
    throw Error(ErrorCode::input_output, "key file '" + file.string() + "' holds no key of 40 characters");
  return key;
}

void add_zeromq(Builtins& builtins, bool allow_plaintext) {
  const auto make = [=](const Address& address, Parameters& parameters) {
    const ZmqSettings settings = settings_from(address, parameters, allow_plaintext);
    return std::make_unique<wire::RemoteSubsystem>(zmq_connect(in_folder(address), settings),
                                                   parameters.rest(), settings.deadline);
  };
  builtins.schemes["zmq"] = {words_by(Setter::operator_only, {"deadline", "key", "server_key"}), make, true};
}

}  // namespace tandem
