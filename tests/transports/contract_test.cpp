// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What every subsystem has to do, over each transport.
#include "c_oscillator.h"
#include "child.hpp"
#include "contract_suite.hpp"
#include "mass2_library.hpp"
#include "peers.hpp"
#include "python.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/peer.h"

namespace tandem::test {
namespace {

std::vector<ContractCase> libraries() {
  std::vector<ContractCase> all;
  for (const std::string& language : library_languages())
    all.push_back({language, [language] {
                     return open(mass2_library(language) + mass2_parameters(), library_sources());
                   }});
  return all;
}
INSTANTIATE_TEST_SUITE_P(SharedLibrary, SubsystemContract, testing::ValuesIn(libraries()), contract_name);

/// One server for all tests: the oscillator in C, and the two masses.
const Served& oscillators(const std::string& address) {
  const auto make = [](const std::string& p) { return std::make_unique<CSubsystem>(c_oscillator(), p); };
  static std::map<std::string, Served> servers;
  const auto there = servers.find(address);
  return there != servers.end() ? there->second
                                : servers.try_emplace(address, listen(address, {}), make).first->second;
}

ContractCase at(const std::string& name, const std::string& address, const std::string& parameters,
                double t_start = 0.0) {
  return {name + parameters,
          [address, parameters] { return open(oscillators(address).address() + parameters, all_sources()); },
          t_start};
}

#if TANDEM_HAS_ZEROMQ
const Served& over_zeromq(const std::string& address) {
  const auto make = [](const std::string& p) { return std::make_unique<CSubsystem>(c_oscillator(), p); };
  static std::map<std::string, Served> servers;
  const auto there = servers.find(address);
  return there != servers.end() ? there->second
                                : servers.try_emplace(address, zmq_listen(address, {}), make).first->second;
}

ContractCase zmq_at(const std::string& name, const std::string& address, const std::string& parameters) {
  return {name + parameters,
          [address, parameters] { return open(over_zeromq(address).address() + parameters, all_sources()); }};
}

INSTANTIATE_TEST_SUITE_P(ZeroMq, SubsystemContract,
                         testing::Values(zmq_at("tcp", "tcp://127.0.0.1:0", "?spin=0"),
                                         zmq_at("tcp", "tcp://127.0.0.1:0", "?m=2&k=30&c=0.1&h=0.013"),
                                         zmq_at("inproc", "inproc://oscillators", "?h=0.03&x0=1&v0=-2")),
                         contract_name);
#endif

/// Goes with the program.
const std::string& unix_address() {
  static const Scratch folder;
  static const std::string address = "unix:" + (folder.path() / "socket").string();
  return address;
}

INSTANTIATE_TEST_SUITE_P(Tcp, SubsystemContract,
                         testing::Values(at("blocking", "tcp://127.0.0.1:0", "?spin=0"),
                                         at("spinning", "tcp://127.0.0.1:0",
                                            "?spin=1000&m=2&k=30&c=0.1&h=0.013"),
                                         at("ipv6", "tcp://[::1]:0", "?h=0.03&x0=1&v0=-2", -7.3)),
                         contract_name);
#if TANDEM_HAS_ZEROMQ
INSTANTIATE_TEST_SUITE_P(ZeroMqIpc, SubsystemContract,
                         testing::Values(zmq_at("ipc", "ipc://" + unix_address().substr(5) + "-zmq", "")),
                         contract_name);
#endif
INSTANTIATE_TEST_SUITE_P(Python, SubsystemContract,
                         testing::Values(ContractCase{"mass2",
                                                      [] { return open(python_mass2(), all_sources()); }}),
                         contract_name);

/// The oscillator again, served by a program in C.
ContractCase served_in_c(const std::string& name, const std::string& address, const std::string& parameters) {
  return {name, [address, parameters] {
            static std::map<std::string, std::unique_ptr<PeerServer>> servers;
            auto& server = servers[address];
            if (!server) server = std::make_unique<PeerServer>(std::vector{oscillator_server()}, address);
            return open(server->address() + parameters, all_sources());
          }};
}
INSTANTIATE_TEST_SUITE_P(CServes, SubsystemContract,
                         testing::Values(served_in_c("tcp", "tcp://127.0.0.1:0", "?m=2&k=30&c=0.1&h=0.013"),
                                         served_in_c("unix", unix_address() + "-c", "?h=0.03&x0=1&v0=-2"),
                                         ContractCase{"spawn",
                                                      [] {
                                                        return open(
                                                            "spawn:" + oscillator_server() + "?h=0.02",
                                                            all_sources());
                                                      }}),
                         contract_name);

/// The oscillator of this program, driven through a client in C.
ContractCase driven_by_c(const std::string& name, const std::string& address, const std::string& parameters) {
  return {name, [address, parameters] {
            return std::make_unique<CSubsystem>(tandem_remote(), oscillators(address).address() + parameters);
          }};
}
INSTANTIATE_TEST_SUITE_P(CDrives, SubsystemContract,
                         testing::Values(driven_by_c("tcp", "tcp://127.0.0.1:0", "?m=2&k=30&c=0.1&h=0.013"),
                                         driven_by_c("unix", unix_address(), "?h=0.03&x0=1&v0=-2")),
                         contract_name);

#ifdef TANDEM_MEX_FOLDER
INSTANTIATE_TEST_SUITE_P(Octave, SubsystemContract,
                         testing::Values(ContractCase{"mass2",
                                                      [] {
                                                        static const PeerServer server(
                                                            octave_program("mass2.m"), unix_address() + "-m");
                                                        return open(server.address() + "?deadline=20&" +
                                                                        mass2_parameters(),
                                                                    all_sources());
                                                      }}),
                         contract_name);
#endif

INSTANTIATE_TEST_SUITE_P(Unix, SubsystemContract,
                         testing::Values(at("blocking", unix_address(), "?spin=0"),
                                         at("spinning", unix_address(), "?m=2&k=30&c=0.1&h=0.013", 1e4)),
                         contract_name);

}  // namespace
}  // namespace tandem::test
