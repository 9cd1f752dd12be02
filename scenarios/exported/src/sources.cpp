// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/sources.hpp"

#include "tandem/error.hpp"
#include "tandem/scenario/nested.hpp"
#include "tandem/sources/diagram.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::exported {

/// An FMU writes no files.
static Source writing_nothing(Source mechanism) {
  mechanism.make = [make = std::move(mechanism.make)](const Address& address, Parameters& p) {
    if (!p.text("matrices", "").empty())
      throw Error(ErrorCode::not_supported,
                  address.name() + ": 'matrices' names a folder of this machine; an FMU writes no files");
    return make(address, p);
  };
  return mechanism;
}

Builtins sources(const std::function<void(const std::string&)>& tell) {
  Builtins all{
      {},
      {{"diagram", diagram_source({}, tell)}, {"mechanism", writing_nothing(mechanism_source({}, tell))}}};
  scenario::add_nested(all);
  return all;
}

}  // namespace tandem::exported
