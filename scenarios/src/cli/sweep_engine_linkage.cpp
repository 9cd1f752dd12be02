// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_engine_linkage.hpp"

#include <fmt/format.h>

#include <functional>

#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "engine_linkage/sweep.hpp"
#include "output/conditions.hpp"
#include "output/ordered_rows.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/parallel.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::cli {
namespace {

using engine_linkage::Case;
using engine_linkage::Outcome;

class EngineLinkageRuns {
 public:
  EngineLinkageRuns(const EngineLinkageSweep& settings, const Context& context)
      : settings_(settings),
        context_(context),
        engine_(engine::read_diagram(settings.scene / "engine.toml")),
        truth_(engine_, 1, engine_linkage::t_stop) {}

  void make() {
    const KeptFolder folder(settings_.output);
    if (!settings_.only_table) std::filesystem::remove(conditions_file());
    run_scene();
    write_schemes("equal_steps.csv", engine_linkage::equal_step_cases());
    const auto cases = engine_linkage::sweep_cases();
    const auto outcomes = write_schemes("schemes.csv", cases);
    if (!settings_.only_table) write_times(cases, outcomes);
  }

 private:
  /// results.csv, as `tandem run` writes it.
  void run_scene() {
    const auto scene = scenario::read(settings_.scene / "engine_linkage.toml", {});
    scenario::Assembly assembly(scene, context_.builtins, false);
    const auto recorder = assembly.recorder(settings_.output);
    assembly.coordinator().observe(recorder.get());
    assembly.initialize();
    assembly.coordinator().run();
    recorder->close();
  }

  std::vector<Outcome> write_schemes(const char* name, const std::vector<Case>& cases) {
    std::vector<Outcome> outcomes(cases.size());
    output::OrderedRows rows(settings_.output / name, engine_linkage::schemes_header);
    Progress progress("sweep", cases.size(), !context_.quiet);
    output::for_each_in_parallel(
        cases.size(), settings_.threads,
        [&](std::size_t i) {
          outcomes[i] = engine_linkage::run_case(cases[i], engine_, truth_);
          rows.set(i, engine_linkage::scheme_row(cases[i], outcomes[i]));
        },
        [&](std::size_t done) {
          progress.update(done);
          return !InterruptGuard::interrupted();
        });
    tell(name, rows.written(), cases.size());
    return outcomes;
  }

  /// One at a time.
  void write_times(const std::vector<Case>& cases, const std::vector<Outcome>& outcomes) {
    const auto sizes = engine_linkage::size_cases();
    Progress progress("times", cases.size() + sizes.size(), !context_.quiet);
    write("elapsed.csv", engine_linkage::elapsed_header, sizes.size(), progress, 0,
          [&](std::size_t i) { return engine_linkage::elapsed_row(sizes[i], engine_); });
    write("work.csv", engine_linkage::work_header, cases.size(), progress, sizes.size(),
          [&](std::size_t i) { return engine_linkage::work_row(cases[i], outcomes[i], engine_); });
    auto conditions =
        output::conditions({"one degree of freedom, CVODE at 1e-10", "largest difference of the bar's speed",
                            "the least of 2 (work), 3 (elapsed)"});
    conditions["truth_seconds"] = truth_.seconds();
    output::write_text(conditions_file(), conditions.dump(2) + "\n");
  }

  void write(const char* name, const char* header, std::size_t count, Progress& progress, std::size_t before,
             const std::function<std::string(std::size_t)>& row) {
    output::OrderedRows rows(settings_.output / name, header);
    for (std::size_t i = 0; i < count && !InterruptGuard::interrupted(); ++i) {
      rows.set(i, row(i));
      progress.update(before + i + 1);
    }
    tell(name, rows.written(), count);
  }

  void tell(const char* name, std::size_t written, std::size_t rows) const {
    const std::string file = (settings_.output / name).string();
    if (written < rows)
      throw RunFailed(fmt::format("interrupted; the first {} of {} rows are in {}", written, rows, file));
    if (!context_.quiet) say("wrote {}\n", file);
  }

  /// There when all else is.
  std::filesystem::path conditions_file() const { return settings_.output / "conditions.json"; }

  const EngineLinkageSweep& settings_;
  const Context& context_;
  engine::Description engine_;
  engine_linkage::Truth truth_;
};

}  // namespace

void sweep_engine_linkage(const EngineLinkageSweep& settings, const Context& context) {
  const InterruptGuard guard;
  EngineLinkageRuns(settings, context).make();
}

}  // namespace tandem::cli
