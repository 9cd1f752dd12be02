// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "child.hpp"

namespace tandem::test {

/// Programs in C of transports/examples and tests/programs.
inline std::string oscillator_server() { return TANDEM_EXAMPLES "/oscillator_server"; }
inline std::string c_mass2() { return TANDEM_EXAMPLES "/example_mass2_server"; }

/// A program that serves at an address, until its owner goes: then it is told to end.
class PeerServer {
 public:
  PeerServer(const std::string& program, const std::string& address)
      : child_({program, "--listen", address}), address_(child_.word_after(" at ")) {}
  ~PeerServer() { child_.signal(SIGTERM), child_.status(); }
  PeerServer(const PeerServer&) = delete;
  PeerServer& operator=(const PeerServer&) = delete;

  const std::string& address() const { return address_; }

 private:
  Child child_;
  std::string address_;
};

}  // namespace tandem::test
