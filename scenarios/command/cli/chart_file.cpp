// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/chart_file.hpp"

#include "cli/study_file.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* ladder_charts = R"toml([[charts]]
name = "ladder"
kind = "work"
table = "ladder"
title = "Difference from the richest model against the processor time of a run"
cost = "seconds"
error = "max(difference/tolerance, 1e-6)"
colour = "rung"
panels = "quantity"
tolerance = 1
notes = ["No difference stands at the foot."]
words = { seconds = "processor time [s]", "max(difference/tolerance, 1e-6)" = "difference / tolerance" }
)toml";

ChartFile of_study(const fs::path& file, const Builtins& builtins) {
  StudyFile found = read_study(file, builtins);
  const auto& tables = found.study.tables;
  return {std::move(found.study.charts), tables.size() == 1 ? tables[0].name : "", found.folder};
}

ChartFile of_charts(const text::Document& document, const fs::path& results) {
  text::Section root(document, charts::keys());
  ChartFile all{charts::read_charts(root), "", results};
  root.refuse_unknown();
  return all;
}

}  // namespace

ChartFile charts_of_ladder() {
  return of_charts(text::Document("the charts of a ladder", ladder_charts), "");
}

ChartFile read_chart_file(const fs::path& file, const Builtins& builtins) {
  const text::Document document(file);
  const auto is_there = [&](const char* key) { return document.table().contains(key); };
  const bool is_study =
      is_there("study") || is_there("tables") || is_there("search") || is_there("subsystems");
  ChartFile all = is_study ? of_study(file, builtins) : of_charts(document, results_of(file));
  if (all.charts.all.empty())
    throw Error(ErrorCode::invalid_argument,
                file.string() + " has no charts; allowed is at least one [[charts]]");
  return all;
}

}  // namespace tandem::cli
