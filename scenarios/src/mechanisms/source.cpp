// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/source.hpp"

#include <algorithm>

#include "mechanisms/view_table.hpp"
#include "sources/elements.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::mechanisms {
namespace {

/// An output for each coordinate of a point, and of a vector that moves, that has none of that name.
void animate(mbs::Description& d) {
  constexpr const char* axes[] = {"x", "y", "z"};
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e) {
    const mbs::Entity& entity = d.entities[static_cast<std::size_t>(e)];
    if (entity.fixed && entity.kind == mbs::Entity::Kind::vector) continue;
    for (int axis = 0; axis < d.dimension; ++axis) {
      const std::string name = entity.name + "." + axes[axis];
      const bool there = std::any_of(d.outputs.begin(), d.outputs.end(),
                                     [&](const mbs::Output& o) { return o.name == name; });
      if (!there) d.outputs.push_back({name, mbs::Output::Kind::position, {e, axis}});
    }
  }
}

void look_at(const text::Document& document, mbs::Description& description, Parameters& p) {
  read_view(document, description);  // refuses what is wrong with it
  if (p.flag("animate", false)) animate(description);
}

}  // namespace

void add_sources(Builtins& builtins, const mbs::TellOfLimit& tell) {
  const auto make = [tell](const Address& address, Parameters& p) {
    return make_mechanism({address.file(), {}, address.overrides}, p, element_kinds(), look_at, tell);
  };
  builtins.schemes["mechanism"] = {mechanism_words() + words_by(Setter::client, {"animate"}), make};
}

Builtins without_matrices(Builtins builtins) {
  Source& mechanism = builtins.schemes["mechanism"];
  mechanism.make = [make = mechanism.make](const Address& address, Parameters& p) {
    p.text("matrices", "");  // refuses what is no text
    p.set("matrices", std::string());
    return make(address, p);
  };
  return builtins;
}

}  // namespace tandem::mechanisms
