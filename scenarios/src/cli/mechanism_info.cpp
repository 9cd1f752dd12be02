// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/mechanism_info.hpp"

#include <fmt/format.h>

#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/tangent.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/document.hpp"

namespace tandem::cli {

bool is_mechanism(const std::filesystem::path& file) {
  return text::Document(file).table().contains("dimension");
}

void print_mechanism(const std::filesystem::path& file) {
  const mbs::Description description = mbs::read_mechanism(file);
  mbs::Mechanism mechanism(description);
  const mbs::Structure& s = mechanism.structure();
  const mbs::Freedom freedom = mbs::freedom(mechanism, mechanism.described_state());
  const mbs::Tangent tangent(s, mbs::make_solver("auto", mbs::MatrixKind::positive_definite));
  std::vector<std::string> redundant;
  for (const int c : freedom.redundant) redundant.push_back(s.constraint_names[c]);
  fmt::print("{}: a mechanism in {}\n", description.name, description.dimension == 2 ? "the plane" : "space");
  fmt::print("  {} bodies, {} points and vectors\n", description.bodies.size(), description.entities.size());
  fmt::print("  {} variables: {}\n", s.variables, listed(s.variable_names));
  fmt::print("  {} constraints: {}\n", s.constraints, listed(s.constraint_names));
  fmt::print("  {} degrees of freedom as drawn\n", freedom.degrees);
  fmt::print("  redundant equations: {}\n", listed(redundant));
  const double n = s.variables;
  fmt::print("  tangent matrix: {} entries, {:.3g} % of it, {:.3g} a row\n", tangent.pattern().size(),
             100.0 * tangent.pattern().size() / (n * n), tangent.pattern().size() / n);
}

}  // namespace tandem::cli
