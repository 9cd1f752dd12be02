// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "scratch.hpp"
#include "tandem/tcp/certificates.hpp"
#include "tandem/tcp/tcp.hpp"

namespace tandem::test {

/// Files of a pair of machines in a folder, valid for so many seconds.
class TlsFolder {
 public:
  explicit TlsFolder(double seconds = 3600.0) {
    const TlsPair pair = make_tls_pair(seconds);
    folder_.write("authority.crt", pair.authority);
    for (const auto& [name, side] : {std::pair("server", pair.server), {"client", pair.client}}) {
      const auto key = folder_.write(std::string(name) + ".key", side.key);
      std::filesystem::permissions(key, std::filesystem::perms::owner_read);
      folder_.write(std::string(name) + ".crt", side.certificate);
    }
  }

  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  /// Of a server, or of whoever has the key of `side`.
  SocketSettings settings(const std::string& side = "server") const {
    return {.tls = {file(side + ".key"), file("authority.crt")}};
  }
  /// The end of a client's URI: the key of `side`, against this authority.
  std::string query(const std::string& side = "client") const {
    return "key=" + file(side + ".key").string() + "&authority=" + file("authority.crt").string();
  }

 private:
  Scratch folder_;
};

}  // namespace tandem::test
