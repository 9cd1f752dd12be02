// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/answer_link.hpp"

#include <stdlib.h>  // mkdtemp

#include "bench/in_turns.hpp"
#include "tandem/error.hpp"
#include "tandem/output/files.hpp"
#include "tandem/tcp/certificates.hpp"
#include "tandem/tcp/tcp.hpp"
#if TANDEM_HAS_ZEROMQ
#include "tandem/zeromq/zeromq.hpp"
#endif

namespace tandem::bench {
namespace {

namespace fs = std::filesystem;

constexpr double longest_wait = 60.0;  // s: no exchange takes so long

}  // namespace

LinkFolder::LinkFolder() {
  std::string name = (fs::temp_directory_path() / "tandem_bench_XXXXXX").string();
  if (!::mkdtemp(name.data())) throw Error(ErrorCode::input_output, "no folder can be made at " + name);
  path_ = name;
  if (has_tls()) write_certificates();
#if TANDEM_HAS_ZEROMQ
  for (const char* who : {"curve_server", "curve_client"}) {
    const CurveKeys keys = make_curve_keys();
    write(who, keys.secret_key);
    write(std::string(who) + ".pub", keys.public_key);
  }
#endif
}

void LinkFolder::write_certificates() const {
  const TlsPair pair = make_tls_pair(86400.0);
  write("server.key", pair.server.key);
  write("server.crt", pair.server.certificate);
  write("client.key", pair.client.key);
  write("client.crt", pair.client.certificate);
  write("authority.crt", pair.authority);
}

LinkFolder::~LinkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void LinkFolder::write(const std::string& name, const std::string& text) const {
  output::write_text(path_ / name, text);
  fs::permissions(path_ / name, fs::perms::owner_read);
}

AnswerLink::Ends AnswerLink::socket_ends(const std::string& transport, double spin,
                                         const LinkFolder& folder) {
  SocketSettings here{longest_wait, spin, false, {}}, there = here;
  if (transport == "tls") {
    here.tls = {folder.file("client.key"), folder.file("authority.crt")};
    there.tls = {folder.file("server.key"), folder.file("authority.crt")};
  }
  const std::string address =
      transport == "unix" ? "unix:" + folder.file("socket") : transport + "://127.0.0.1:0";
  return {listen(address, there), [here](const std::string& at) { return connect(at, here); }};
}

AnswerLink::Ends AnswerLink::zeromq_ends([[maybe_unused]] const std::string& transport,
                                         [[maybe_unused]] const LinkFolder& folder) {
#if TANDEM_HAS_ZEROMQ
  ZmqSettings here{longest_wait, false, {}, {}, {}}, there = here;
  if (transport == "zmq:curve") {
    here.keys = make_curve_keys();
    there.keys = make_curve_keys();
    here.server_key = there.keys.public_key;
    there.clients = {here.keys.public_key};
  }
  return {zmq_listen(transport == "zmq:ipc" ? "ipc://" + folder.file("zmq") : "tcp://127.0.0.1:*", there),
          [here](const std::string& at) { return zmq_connect(at.substr(4), here); }};
#else
  throw Error(ErrorCode::not_supported, "this build has no ZeroMQ (packages cppzmq-dev, libzmq3-dev)");
#endif
}

AnswerLink::AnswerLink(const std::string& transport, const Shape& shape, double spin,
                       const LinkFolder& folder) {
  Ends ends =
      transport.starts_with("zmq:") ? zeromq_ends(transport, folder) : socket_ends(transport, spin, folder);
  listener_ = std::move(ends.listener);
  thread_ = std::thread([this, shape] { serve(shape); });
  try {
    remote_ = std::make_unique<wire::RemoteSubsystem>(ends.connect(listener_->address()), "", longest_wait);
    asking_ = std::make_unique<Asking>(*remote_, shape);
  } catch (...) {
    stop_ = true;
    thread_.join();
    throw;
  }
}

AnswerLink::~AnswerLink() {
  remote_.reset();
  stop_ = true;
  thread_.join();
}

void AnswerLink::serve(const Shape& shape) {
  pin(places().there);
  wire::ServerSettings settings;
  settings.session.deadline = longest_wait;
  wire::Server(
      *listener_, [shape](const std::string&) { return answer(shape); }, settings)
      .run([this] { return stop_.load(); });
}

std::vector<std::string> linked_transports() {
  std::vector<std::string> names = {"tcp", "unix"};
  if (has_tls()) names.push_back("tls");
#if TANDEM_HAS_ZEROMQ
  names.insert(names.end(), {"zmq:tcp", "zmq:ipc", "zmq:curve"});
#endif
  return names;
}

}  // namespace tandem::bench
