// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "languages/languages.hpp"

#include "engine_models/compiled.hpp"
#include "sources/elements.hpp"
#include "tandem/engine/keys.hpp"
#include "tandem/mbs/mechanism/keys.hpp"
#include "tandem/scenario/keys.hpp"
#include "tandem/study/study.hpp"

namespace tandem::scenario {

const std::map<std::string, text::Keys>& languages() {
  static const std::map<std::string, text::Keys> all = {
      {"diagram", engine::diagram_keys(engine_models::compiled_kinds())},
      {"mechanism", mbs::mechanism_keys(element_kinds())},
      {"scenario", keys()},
      {"study", study::keys()}};
  return all;
}

}  // namespace tandem::scenario
