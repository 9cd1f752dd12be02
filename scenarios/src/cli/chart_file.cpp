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

ChartFile of_charts(const fs::path& file, const text::Document& document) {
  text::Section root(document, charts::keys());
  ChartFile all{charts::read_charts(root), "", results_of(file)};
  root.refuse_unknown();
  return all;
}

}  // namespace

ChartFile read_chart_file(const fs::path& file, const Builtins& builtins) {
  const text::Document document(file);
  const auto is_there = [&](const char* key) { return document.table().contains(key); };
  const bool is_study =
      is_there("study") || is_there("tables") || is_there("search") || is_there("subsystems");
  ChartFile all = is_study ? of_study(file, builtins) : of_charts(file, document);
  if (all.charts.all.empty())
    throw Error(ErrorCode::invalid_argument,
                file.string() + " has no charts; allowed is at least one [[charts]]");
  return all;
}

}  // namespace tandem::cli
