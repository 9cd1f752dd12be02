// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What every subsystem has to do, over each transport.
#include <functional>
#include <map>

#include "c_oscillator.h"
#include "child.hpp"
#include "contract_suite.hpp"
#include "curve_pair.hpp"
#include "mass2_library.hpp"
#include "peers.hpp"
#include "python.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/peer.h"
#include "three_functions.hpp"
#include "tls_pair.hpp"

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

INSTANTIATE_TEST_SUITE_P(ThreeFunctions, SubsystemContract,
                         testing::Values(ContractCase{"euler", [] { return open_three(its_ports); }}),
                         contract_name);

using Listen = std::function<std::unique_ptr<wire::Listener>()>;

/// Servers of the oscillator in C that all tests share, by name.
const Served& oscillators(const std::string& name, const Listen& listening) {
  const auto make = [](const std::string& p) { return std::make_unique<CSubsystem>(c_oscillator(), p); };
  static std::map<std::string, Served> servers;
  const auto there = servers.find(name);
  return there != servers.end() ? there->second : servers.try_emplace(name, listening(), make).first->second;
}

/// Of the server of that name; `query` of its URI may begin with keys.
ContractCase over(const std::string& name, const Listen& listening, const std::string& query,
                  double t_start = 0.0) {
  return {name, [=] { return open(oscillators(name, listening).address() + query, all_sources()); }, t_start};
}

/// Goes with the program.
const std::string& socket_path() {
  static const Scratch folder;
  static const std::string path = (folder.path() / "socket").string();
  return path;
}

Listen at(const std::string& address) {
  return [address] { return listen(address, {}); };
}

INSTANTIATE_TEST_SUITE_P(Tcp, SubsystemContract,
                         testing::Values(over("blocking", at("tcp://127.0.0.1:0"), "?spin=0"),
                                         over("spinning", at("tcp://127.0.0.1:0"),
                                              "?spin=1000&m=2&k=30&c=0.1&h=0.013"),
                                         over("ipv6", at("tcp://[::1]:0"), "?h=0.03&x0=1&v0=-2", -7.3)),
                         contract_name);
INSTANTIATE_TEST_SUITE_P(Unix, SubsystemContract,
                         testing::Values(over("unix_blocking", at("unix:" + socket_path()), "?spin=0"),
                                         over("unix_spinning", at("unix:" + socket_path() + "2"),
                                              "?m=2&k=30&c=0.1&h=0.013", 1e4)),
                         contract_name);
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
INSTANTIATE_TEST_SUITE_P(
    CServes, SubsystemContract,
    testing::Values(served_in_c("tcp", "tcp://127.0.0.1:0", "?m=2&k=30&c=0.1&h=0.013"),
                    served_in_c("unix", "unix:" + socket_path() + "-c", "?h=0.03&x0=1&v0=-2"),
                    ContractCase{
                        "spawn",
                        [] { return open("spawn:" + oscillator_server() + "?h=0.02", all_sources()); }}),
    contract_name);

/// The oscillator of this program, driven through a client in C.
ContractCase driven_by_c(const std::string& name, const Listen& listening, const std::string& parameters) {
  return {name, [=] {
            return std::make_unique<CSubsystem>(tandem_remote(),
                                                oscillators(name, listening).address() + parameters);
          }};
}
INSTANTIATE_TEST_SUITE_P(
    CDrives, SubsystemContract,
    testing::Values(driven_by_c("c_tcp", at("tcp://127.0.0.1:0"), "?m=2&k=30&c=0.1&h=0.013"),
                    driven_by_c("c_unix", at("unix:" + socket_path() + "3"), "?h=0.03&x0=1&v0=-2")),
    contract_name);

#ifdef TANDEM_MEX_FOLDER
INSTANTIATE_TEST_SUITE_P(Octave, SubsystemContract,
                         testing::Values(ContractCase{
                             "mass2",
                             [] {
                               static const PeerServer server(octave_program("mass2.m"),
                                                              "unix:" + socket_path() + "-m");
                               return open(server.address() + "?deadline=20&" + mass2_parameters(),
                                           all_sources());
                             }}),
                         contract_name);
#endif

#if TANDEM_HAS_TLS
const TlsFolder& tls_keys() {
  static const TlsFolder keys;
  return keys;
}

ContractCase tls_over(const std::string& name, const std::string& address, const std::string& query) {
  return over(
      name, [address] { return listen(address, tls_keys().settings()); }, "?" + tls_keys().query() + query);
}

INSTANTIATE_TEST_SUITE_P(Tls, SubsystemContract,
                         testing::Values(tls_over("tls_blocking", "tls://127.0.0.1:0", "&spin=0"),
                                         tls_over("tls_spinning", "tls://[::1]:0",
                                                  "&spin=1000&m=2&k=30&c=0.1&h=0.013")),
                         contract_name);
#endif

#if TANDEM_HAS_ZEROMQ
ContractCase zmq_over(const std::string& name, const std::string& address, const std::string& query,
                      const ZmqSettings& settings = {}) {
  return over(
      name, [=] { return zmq_listen(address, settings); }, query);
}

/// A pair of CURVE keys in files that go with the program.
ContractCase curve_over(const std::string& name, const std::string& query) {
  static const CurveFolder keys;
  return zmq_over(name, "tcp://127.0.0.1:0", "?" + keys.query() + query, keys.settings());
}

INSTANTIATE_TEST_SUITE_P(ZeroMq, SubsystemContract,
                         testing::Values(zmq_over("zmq_tcp", "tcp://127.0.0.1:0", "?m=2&k=30&c=0.1&h=0.013"),
                                         zmq_over("zmq_inproc", "inproc://oscillators", "?h=0.03&x0=1&v0=-2"),
                                         zmq_over("zmq_ipc", "ipc://" + socket_path() + "-zmq", ""),
                                         curve_over("zmq_curve", "&h=0.03&x0=1&v0=-2")),
                         contract_name);
#endif

}  // namespace
}  // namespace tandem::test
