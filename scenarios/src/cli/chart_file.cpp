// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/chart_file.hpp"

#include "cli/study_file.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

ChartFile of_study(const fs::path& file, const Builtins& builtins) {
  StudyFile found = read_study(file, builtins);
  const auto& tables = found.study.tables;
  return {std::move(found.study.charts), tables.size() == 1 ? tables[0].name : "", found.folder};
}

ChartFile of_charts(const text::Document& document) {
  text::Section root(document, charts::keys());
  const auto results = root.text("results");
  ChartFile all{charts::read_charts(root), "", results.value_or("")};
  root.refuse_unknown();
  return all;
}

}  // namespace

ChartFile read_chart_file(const fs::path& file, const Builtins& builtins) {
  const text::Document document(file);
  const auto& table = document.table();
  const bool is_study = table.contains("study") || table.contains("tables") || table.contains("subsystems");
  ChartFile all = is_study ? of_study(file, builtins) : of_charts(document);
  if (all.charts.all.empty())
    throw Error(ErrorCode::invalid_argument,
                file.string() + " has no charts; allowed is at least one [[charts]]");
  if (all.results.empty())
    all.results = fs::path("results") / fs::weakly_canonical(file).parent_path().filename();
  return all;
}

}  // namespace tandem::cli
