// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/study_file.hpp"

#include "tandem/scenario/document_of.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/study/standing.hpp"

namespace tandem::cli {

namespace fs = std::filesystem;

fs::path study_path(const std::string& name) {
  return name.ends_with(".toml") || fs::is_regular_file(name) ? fs::path(name)
                                                              : fs::path("scenarios") / name / "study.toml";
}

fs::path results_of(const fs::path& file) {
  return fs::path("results") / fs::weakly_canonical(file).parent_path().filename();
}

StudyFile read_study(const fs::path& file, const Builtins& builtins,
                     const std::vector<std::string>& overrides, std::uint64_t seed) {
  const fs::path folder = results_of(file);
  const text::Document document = scenario::document_of(file);
  const bool standing = document.table().contains("subsystems") && !document.table().contains("study");
  if (!standing) return {study::read(file, seed), false, folder};
  const auto scenario = scenario::read(file, overrides);
  const auto text = scenario.chooses ? study::standing_study(scenario::with_usual(scenario), builtins,
                                                             {study::Varied::left_out})
                                     : study::standing_study(scenario, builtins);
  return {study::read(file, text), true, folder / file.stem()};
}

}  // namespace tandem::cli
