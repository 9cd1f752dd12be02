// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/exchanged_unit.hpp"
#include "tandem/exported/stepped_unit.hpp"

namespace tandem::exported {

std::unique_ptr<Unit> open_unit(const std::filesystem::path& resources, const Unit::Tell& tell) {
  if (read_manifest(resources / manifest_name).interface == Interface::model_exchange)
    return std::make_unique<ExchangedUnit>(resources, tell);
  return std::make_unique<SteppedUnit>(resources, tell);
}

}  // namespace tandem::exported
