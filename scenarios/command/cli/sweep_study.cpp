// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_study.hpp"

#include <spdlog/spdlog.h>

#include <optional>

#include "cli/interrupt.hpp"
#include "cli/mpi_ranks.hpp"
#include "cli/say.hpp"
#include "cli/study_file.hpp"
#include "metrics/all.hpp"
#include "tandem/error.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/progress.hpp"
#include "tandem/study/standing.hpp"
#include "tandem/study/sweep.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

/// A bar for the references, then one for the rows.
class Bars {
 public:
  explicit Bars(bool shown) : shown_(shown) {}
  void come(const std::string& what, std::size_t done, std::size_t all) {
    if (what != what_) bar_.emplace(what, all, shown_), what_ = what;
    bar_->update(done);
  }

 private:
  bool shown_;
  std::string what_;
  std::optional<output::Progress> bar_;
};

study::SweepEnd swept(study::Sweep& sweep, const Context& context) {
  const InterruptGuard guard;
  Bars bars(!context.quiet);
  try {
    return sweep.run(
        {[] { return !InterruptGuard::interrupted(); },
         [&](const char* what, std::size_t done, std::size_t all) { bars.come(what, done, all); }});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::input_output) throw;
    throw RunFailed(error.what());  // begun and not ended: a full disk, say
  }
}

std::string told(const study::SweepEnd& end) {
  std::string text = fmt::format("{} rows", end.rows);
  if (end.kept > 0) text += fmt::format(", {} kept", end.kept);
  for (const auto& [status, count] : end.statuses)
    if (count > 0) text += fmt::format(", {} {}", count, status);
  return text;
}

StudyFile found(const StudySweep& settings, const Context& context) {
  if (settings.study.empty())
    return read_study(settings.file, context.builtins, settings.overrides, settings.seed);
  return {study::read(settings.file, settings.study), false, results_of(settings.file)};
}

}  // namespace

void sweep_study(const StudySweep& settings, const Context& context) {
  auto [study, standing, folder] = found(settings, context);
  if (!standing && settings.study.empty()) study::refuse_without_effect(settings.overrides, study);
  if (!settings.output.empty()) folder = settings.output;
  if (!settings.tables.empty()) study.keep_tables(settings.tables);
  if (!settings.where.empty()) study.keep_rows(settings.where);
  const auto ranks = settings.dry ? nullptr : mpi_ranks();
  study::Sweep sweep(
      study, context.builtins,
      {folder, settings.overrides, all_metrics(), settings.threads, settings.resume, ranks.get()});
  if (settings.dry) {
    for (const std::string& line : sweep.plan()) say("{}\n", line);
    return;
  }
  const bool is_helper = ranks && ranks->rank() != 0;
  if (!is_helper) output::check_folder(folder);
  const auto end = swept(sweep, context);
  if (is_helper) return;
  for (const std::string& note : end.notes) spdlog::warn("note: {}", printable(note));
  if (end.interrupted)
    throw RunFailed(fmt::format("interrupted; {} of {} rows are kept in {}, --resume goes on from there",
                                end.done, end.rows, folder.string()));
  if (!context.quiet) {
    say("{}\n", told(end));
    for (const fs::path& file : end.files) say("wrote {}\n", file.string());
    if (standing) say("\n{}", study::standing_verdict(folder));
  }
  const auto count = [&](const char* status) {
    const auto it = end.statuses.find(status);
    return it == end.statuses.end() ? 0 : it->second;
  };
  if (count("failed") > 0 && count("failed") + count("refused") == end.rows && !end.reference_failed)
    throw RunFailed("no row came to a result; its column note tells why");
  if (end.reference_failed)
    throw RunFailed("a reference failed; the rows that need it have the status failed");
}

}  // namespace tandem::cli
