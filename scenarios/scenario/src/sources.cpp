// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/sources.hpp"

#include "tandem/scenario/impulse_source.hpp"
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

Builtins sources(const SourceSettings& settings) {
  Builtins all;
  all.schemes["mechanism"] = mechanism_source({}, settings.tell);
  all.schemes["diagram"] = diagram_source({}, settings.tell);
  add_nested(all);
  add_impulse(all);
  all.schemes["functions"] = functions_source();
  add_shared_library(all);
  add_tcp(all, settings.allow_plaintext);
#if TANDEM_HAS_FMI
  add_fmi(all, settings.tell, {integrator_words(), take_integrator});
#endif
#if TANDEM_HAS_ZEROMQ
  add_zeromq(all, settings.allow_plaintext);
#endif
  return all;
}

}  // namespace tandem::scenario
