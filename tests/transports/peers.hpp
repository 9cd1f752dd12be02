// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "child.hpp"

namespace tandem::test {

/// Programs in C of transports/examples and tests/programs.
inline std::string oscillator_server() { return TANDEM_EXAMPLES "/oscillator_server"; }
inline std::string c_mass2() { return TANDEM_EXAMPLES "/example_mass2_server"; }

#ifdef TANDEM_MEX_FOLDER
/// Words of a command that runs a file of transports/examples in Octave, without installing the package.
inline std::vector<std::string> octave_program(const std::string& file) {
  return {"env", "TANDEM_MEX_FOLDER=" TANDEM_MEX_FOLDER, TANDEM_SOURCE_DIR "/transports/octave/run",
          TANDEM_SOURCE_DIR "/transports/examples/" + file};
}
#endif

/// A program that serves at an address, until its owner goes: then it is told to end.
class PeerServer {
 public:
  PeerServer(std::vector<std::string> words, const std::string& address)
      : child_(with(std::move(words), address)), address_(child_.word_after(" at ")) {}
  ~PeerServer() { child_.signal(SIGTERM), child_.status(); }
  PeerServer(const PeerServer&) = delete;
  PeerServer& operator=(const PeerServer&) = delete;

  const std::string& address() const { return address_; }

 private:
  static std::vector<std::string> with(std::vector<std::string> words, const std::string& address) {
    words.insert(words.end(), {"--listen", address});
    return words;
  }

  Child child_;
  std::string address_;
};

}  // namespace tandem::test
