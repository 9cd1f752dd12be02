// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Any text as a mechanism's file: one that is assembled and placed, or an Error.
#include <cstdint>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/freedom.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/modes.hpp"
#include "tandem/mbs/mechanism/outputs.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace {

using namespace tandem::mbs;

/// Of variables: the dense methods take the cube of them.
constexpr std::size_t most_places = 16;

/// As `tandem info` and `tandem modes` do.
void assemble(const Description& description) {
  if (description.entities.size() + description.relatives.size() > most_places) return;
  Mechanism mechanism(description);
  Outputs outputs(mechanism);
  const State state = initial_state(mechanism, 0.0);
  freedom(mechanism, state);
  modes(mechanism, state);
  std::vector<double> values(static_cast<std::size_t>(outputs.size()));
  outputs.start(state);
  outputs.evaluate(state, values.data());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    assemble(read_mechanism("fuzz", std::string(reinterpret_cast<const char*>(data), size)));
  } catch (const tandem::Error&) {  // what has to come of a text that is not right
  }
  return 0;
}
