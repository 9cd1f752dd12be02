// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/sources.hpp"

#include "tandem/error.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/shared_library/shared_library.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/sources/functions.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/tcp/tcp.hpp"
#if TANDEM_HAS_FMI
#include "tandem/fmi/fmi.hpp"
#include "tandem/sources/integrators.hpp"
#endif
#if TANDEM_HAS_ZEROMQ
#include "tandem/zeromq/zeromq.hpp"
#endif

namespace tandem::scenario {
namespace {

/// A scheme that this build lacks, which says so.
[[maybe_unused]] void leave_out(Builtins& builtins, const std::string& scheme, const std::string& packages) {
  const auto refuse = [=](const Address& address, Parameters&) -> std::unique_ptr<Subsystem> {
    throw Error(ErrorCode::not_supported, address.name() + " can't be opened: this build has no " + scheme +
                                              ":, as a package was absent when it was configured (" +
                                              packages + ")");
  };
  builtins.schemes[scheme] = {{}, refuse, false, true, [refuse](const Address& address, Parameters& p) {
                                refuse(address, p);
                                return std::optional<Look>();
                              }};
}

}  // namespace

Builtins sources(const SourceSettings& settings) {
  Builtins all;
  all.schemes["mechanism"] = mechanism_source({}, settings.tell);
  all.schemes["diagram"] = diagram_source({}, settings.tell);
  add_nested(all);
  all.models[impulse_model] = {{}, [](const Address&, Parameters&) -> std::unique_ptr<Subsystem> {
                                 throw Error(ErrorCode::not_supported,
                                             "an impulse surrogate can't be opened by itself; allowed is "
                                             "coordination.coupling, which puts it between two sides");
                               }};
  all.schemes["functions"] = functions_source();
  add_shared_library(all);
  add_tcp(all, settings.allow_plaintext);
#if TANDEM_HAS_FMI
  add_fmi(all, settings.tell, {integrator_words(), take_integrator});
#else
  leave_out(all, "fmu", "libpugixml-dev, libminizip-dev");
#endif
#if TANDEM_HAS_ZEROMQ
  add_zeromq(all, settings.allow_plaintext);
#else
  leave_out(all, "zmq", "cppzmq-dev, libzmq3-dev");
#endif
  return all;
}

}  // namespace tandem::scenario
