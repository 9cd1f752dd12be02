// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_kart_drive.hpp"

#include <fmt/format.h>

#include "cli/kept_folder.hpp"
#include "cli/say.hpp"
#include "kart/monolithic.hpp"
#include "kart/plane.hpp"

namespace tandem::cli {

void sweep_kart_drive(const std::filesystem::path& output, const Context& context) {
  const KeptFolder folder(output);
  kart::Plane plane(kart::KartData{}, kart::TyreLaw::magic_formula);
  kart::write_drive(kart::run_monolithic(plane, 1e-4), output / "drive.csv");
  if (!context.quiet) say("wrote {}\n", (output / "drive.csv").string());
}

}  // namespace tandem::cli
