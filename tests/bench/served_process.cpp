// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/served_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sources/this_program.hpp"
#include "tandem/error.hpp"
#include "tandem/start_process.hpp"

namespace tandem::bench {
namespace {

/// Where it listens, and the words about keys of either side.
struct Meeting {
  std::string address;
  std::vector<std::string> server_words = {};
  std::string client_query = {};
};

Meeting meeting(const std::string& transport, const LinkFolder& folder) {
  const std::string port = "tcp://127.0.0.1:0", authority = folder.file("authority.crt");
  if (transport == "unix") return {"unix:" + folder.file("served")};
  if (transport == "tls")
    return {"tls://127.0.0.1:0",
            {"--key", folder.file("server.key"), "--authority", authority},
            "&key=" + folder.file("client.key") + "&authority=" + authority};
  if (transport == "zmq:ipc") return {"zmq:ipc://" + folder.file("served")};
  if (transport == "zmq:curve")
    return {
        "zmq:" + port,
        {"--key", folder.file("curve_server"), "--client-key", folder.file("curve_client.pub")},
        fmt::format("&key={}&server_key={}", folder.file("curve_client"), folder.file("curve_server.pub"))};
  return {transport == "zmq:tcp" ? "zmq:" + port : port};
}

std::string first_line(int descriptor) {
  std::string line;
  char c = 0;
  while (c != '\n') {
    const ssize_t count = ::read(descriptor, &c, 1);
    if (count == 0 || (count < 0 && errno != EINTR)) break;
    if (count > 0 && c != '\n') line += c;
  }
  return line;
}

}  // namespace

ServedProcess::ServedProcess(const std::string& source, const std::string& transport,
                             const LinkFolder& folder) {
  const Meeting meet = meeting(transport, folder);
  std::vector<std::string> words = {
      program_beside("tandem"), "--quiet", "serve", source, "--once", "--listen", meet.address};
  words.insert(words.end(), meet.server_words.begin(), meet.server_words.end());
  int pipe[2];
  if (::pipe2(pipe, O_CLOEXEC) != 0)
    throw Error(ErrorCode::internal, std::string("no pipe: ") + std::strerror(errno));
  process_ = start_process({.words = words, .output = pipe[1]});
  ::close(pipe[1]);
  const std::string line = first_line(pipe[0]);
  ::close(pipe[0]);
  const auto at = line.rfind(" at ");
  if (at == std::string::npos) {
    end_of_process(process_);
    throw Error(ErrorCode::internal, "'" + source + "' is not served at " + meet.address);
  }
  uri_ = line.substr(at + 4) + "?deadline=60" + meet.client_query;
}

ServedProcess::~ServedProcess() {
  ::kill(process_, SIGTERM);
  end_of_process(process_);
}

}  // namespace tandem::bench
