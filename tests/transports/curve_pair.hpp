// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#if TANDEM_HAS_ZEROMQ
#include <string>

#include "scratch.hpp"
#include "tandem/zeromq/zeromq.hpp"

namespace tandem::test {

/// CURVE keys of a pair of machines in files of a folder.
class CurveFolder {
 public:
  CurveFolder() {
    for (const std::string name : {"server", "client"}) {
      const CurveKeys keys = make_curve_keys();
      std::filesystem::permissions(folder_.write(name, keys.secret_key + "\n"),
                                   std::filesystem::perms::owner_read);
      folder_.write(name + ".pub", keys.public_key + "\n");
    }
  }

  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  /// Of the server, which lets the client in.
  ZmqSettings settings() const {
    return {.keys = {read_curve_key(file("server.pub"), false), read_curve_key(file("server"), true)},
            .clients = {read_curve_key(file("client.pub"), false)}};
  }
  /// The end of a client's URI: with the key `own`, for the server with the key `server`.
  std::string query(const std::string& own = "client", const std::string& server = "server") const {
    return "key=" + file(own).string() + "&server_key=" + file(server + ".pub").string();
  }

 private:
  Scratch folder_;
};

}  // namespace tandem::test
#endif
