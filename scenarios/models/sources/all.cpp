// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/all.hpp"

#include "engine_linkage/linkage.hpp"
#include "engine_models/compiled.hpp"
#include "kart/builtins.hpp"
#include "oscillator/side.hpp"
#include "sources/elements.hpp"
#include "split_pendulum/exact.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/sources/mechanism.hpp"
#include "two_mass/masses.hpp"

namespace tandem {

Builtins all_sources(const scenario::SourceSettings& settings) {
  Builtins all = scenario::sources(settings);
  all.schemes["mechanism"] = mechanism_source(element_kinds(), settings.tell);
  all.schemes["diagram"] = diagram_source(engine_models::compiled_kinds(), settings.tell);
  scenario::add_nested(all);
  two_mass::add_builtins(all);
  kart::add_builtins(all, settings.tell);
  engine_linkage::add_builtins(all, settings.tell);
  oscillator::add_builtins(all);
  split_pendulum::add_builtins(all);
  return all;
}

}  // namespace tandem
