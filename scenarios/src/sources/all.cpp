// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sources/all.hpp"

#include "kart/builtins.hpp"
#include "mechanisms/source.hpp"
#include "sources/diagram.hpp"
#include "sources/functions.hpp"
#include "two_mass/masses.hpp"

namespace tandem {

void add_sources(Builtins& builtins, const std::function<void(const std::string&)>& tell) {
  two_mass::add_builtins(builtins);
  kart::add_builtins(builtins, tell);
  mechanisms::add_sources(builtins, tell);
  diagrams::add_sources(builtins, tell);
  functions::add_sources(builtins);
}

}  // namespace tandem
