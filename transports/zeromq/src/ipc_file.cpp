// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ipc_file.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace tandem::zeromq {
namespace {

constexpr int backlog = 100;  // as ZeroMQ has it

/// Of "ipc://PATH"; "" of other addresses.
std::string path_of(const std::string& address) {
  return address.starts_with("ipc://") ? address.substr(6) : "";
}

/// False: the path is too long.
bool put_path(const std::string& path, sockaddr_un& place) {
  if (path.size() >= sizeof place.sun_path) return false;
  place.sun_family = AF_UNIX;
  std::memcpy(place.sun_path, path.data(), path.size());
  return true;
}

/// Not waited for: with a full queue it does not refuse.
bool refuses(const std::string& path) {
  sockaddr_un place{};
  if (!put_path(path, place)) return false;
  const int probe = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (probe < 0) return false;
  const bool refused =
      ::connect(probe, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 && errno == ECONNREFUSED;
  ::close(probe);
  return refused;
}

/// A socket of the system that listens there. A file that is there is replaced.
int listen_at(const std::string& path) {
  sockaddr_un place{};
  errno = ENAMETOOLONG;
  if (!put_path(path, place)) throw zmq::error_t();
  const int listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (listening < 0) throw zmq::error_t();
  ::unlink(path.c_str());
  if (::bind(listening, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 &&
      ::listen(listening, backlog) == 0)
    return listening;
  const int why = errno;
  ::close(listening);
  errno = why;
  throw zmq::error_t();
}

}  // namespace

bool taken(const std::string& address) {
  const std::string path = path_of(address);
  struct stat status {};
  if (path.empty() || ::lstat(path.c_str(), &status) != 0) return false;
  return !S_ISSOCK(status.st_mode) || !refuses(path);
}

SocketFile bind_with_file(zmq::socket_t& socket, const std::string& address) {
  SocketFile file;
  if (const std::string path = path_of(address); !path.empty()) {
    socket.set(zmq::sockopt::use_fd, listen_at(path));  // which is ZeroMQ's from now on
    file = SocketFile(path);
  }
  bind_to(socket, address);
  return file;
}

}  // namespace tandem::zeromq
