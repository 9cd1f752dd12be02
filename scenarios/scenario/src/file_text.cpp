// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/file_text.hpp"

#include <limits>

#include "tandem/input_file.hpp"
#include "tandem/text/nesting.hpp"
#if TANDEM_HAS_FMI
#include "tandem/fmi/packed_file.hpp"
#include "tandem/ssp/ssp.hpp"
#endif

namespace tandem::scenario {

bool is_system(const std::filesystem::path& file) {
  return file.extension() == ".ssp" || file.extension() == ".ssd";
}

FileText file_text(const std::filesystem::path& file) {
  if (!is_system(file)) return {read_file(file, text::longest_document)};
#if TANDEM_HAS_FMI
  ssp::ScenarioText system = ssp::scenario_text(file);
  return {std::move(system.text), std::move(system.lines), std::move(system.remarks)};
#else
  throw Error(
      ErrorCode::not_supported,
      "'" + file.string() + "' is a system of SSP, which this build has not: it needs pugixml and minizip");
#endif
}

std::string source_contents(const std::filesystem::path& file) {
#if TANDEM_HAS_FMI
  return read_file(fmi::PackedFile(file).on_disk(), std::numeric_limits<std::uint64_t>::max());
#else
  return read_file(file, std::numeric_limits<std::uint64_t>::max());
#endif
}

}  // namespace tandem::scenario
