// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_kart.hpp"

#include <fmt/format.h>

#include <iterator>

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "kart/sweep.hpp"
#include "output/conditions.hpp"
#include "output/files.hpp"

namespace tandem::cli {
namespace {

/// A table that grows row by row.
struct Table {
  const char* name;
  std::string text;
};

class KartRuns {
 public:
  KartRuns(const KartSweep& settings, const Context& context)
      : settings_(settings),
        context_(context),
        scene_{settings.scene, context.builtins},
        schemes_(kart::schemes()),
        levels_(settings.levels),
        tables_{{"multirate.csv", std::string(kart::multirate_header) + "\n"},
                {"schemes.csv", std::string(kart::schemes_header) + "\n"}},
        progress_("sweep", size(), !context.quiet) {
    if (settings.only_table) return;
    tables_.push_back({"work.csv", std::string(kart::work_header) + "\n"});
    tables_.push_back({"traces.csv", kart::traces_header() + "\n"});
  }

  void make() {
    output::make_folder(settings_.output);
    for (const std::string& level : levels_) {
      kart::Judge judge(scene_, level);
      add_multirate(judge);
      add_schemes(judge);
      if (!settings_.only_table) add_work(judge);
    }
    for (const Table& table : tables_) output::write_text(settings_.output / table.name, table.text);
    output::write_text(
        settings_.output / "conditions.json",
        output::conditions({"both sides at 0.1 ms, fastest-first, speeds of degree 2, mean torque",
                            "largest difference of the pitch at the kart's steps",
                            "one run (multirate, schemes), the least of 2 (work)"})
                .dump(2) +
            "\n");
    if (context_.quiet) return;
    for (const Table& table : tables_) fmt::print("wrote {}\n", (settings_.output / table.name).string());
  }

 private:
  std::size_t size() {
    if (levels_.empty()) levels_.assign(std::begin(kart::levels), std::end(kart::levels));
    const std::size_t work =
        settings_.only_table ? 0 : kart::work_schemes().size() * std::size(kart::work_ratios);
    return levels_.size() * (std::size(kart::ratios) + schemes_.size() + work);
  }

  void add_multirate(kart::Judge& judge) {
    double seconds = 0.0;
    for (const int ratio : kart::ratios) {
      const kart::Outcome o =
          ratio == 1 ? judge.judge_thesis() : judge.judge(ratio, kart::thesis_scheme, true);
      if (ratio == 1) seconds = o.course.seconds;
      add(0, kart::multirate_row(judge.level(), ratio, seconds, o));
    }
  }

  void add_schemes(kart::Judge& judge) {
    constexpr int ratio = 100;
    kart::Extremes extremes;
    for (const kart::Scheme& scheme : schemes_) {
      const kart::Outcome o = judge.judge(ratio, scheme, false);
      extremes.add(scheme, o);
      add(1, kart::scheme_row(judge.level(), ratio, scheme, o));
    }
    if (!settings_.only_table) tables_[3].text += kart::trace_rows(judge, extremes);
  }

  void add_work(kart::Judge& judge) {
    for (const int ratio : kart::work_ratios)
      for (const kart::Scheme& scheme : kart::work_schemes()) add(2, kart::work_row(judge, ratio, scheme));
  }

  void add(std::size_t table, const std::string& row) {
    tables_[table].text += row + "\n";
    if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing more is written");
    progress_.update(++done_);
  }

  const KartSweep& settings_;
  const Context& context_;
  kart::Scene scene_;
  std::vector<kart::Scheme> schemes_;
  std::vector<std::string> levels_;
  std::vector<Table> tables_;
  Progress progress_;
  std::size_t done_ = 0;
};

}  // namespace

void sweep_kart(const KartSweep& settings, const Context& context) {
  const InterruptGuard guard;
  KartRuns(settings, context).make();
}

}  // namespace tandem::cli
