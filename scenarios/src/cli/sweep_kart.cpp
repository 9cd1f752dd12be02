// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/sweep_kart.hpp"

#include <fmt/format.h>

#include <deque>
#include <iterator>

#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "kart/sweep.hpp"
#include "output/conditions.hpp"
#include "output/ordered_rows.hpp"
#include "tandem/output/files.hpp"

namespace tandem::cli {
namespace {

class KartRuns {
 public:
  KartRuns(const KartSweep& settings, const Context& context)
      : folder_(settings.output),
        settings_(settings),
        context_(context),
        scene_{settings.scene, context.builtins},
        schemes_(kart::schemes()),
        levels_(settings.levels),
        progress_("sweep", size(), !context.quiet) {
    std::filesystem::remove(settings_.output / conditions_);
    open("multirate.csv", kart::multirate_header);
    open("schemes.csv", kart::schemes_header);
    open("shares.csv", kart::shares_header);
    if (settings.only_table) return;
    open("work.csv", kart::work_header);
    open("traces.csv", kart::traces_header());
  }

  void make() {
    for (const std::string& level : levels_) {
      kart::Judge judge(scene_, level);
      add_multirate(judge);
      add_schemes(judge);
      if (!settings_.only_table) add_work(judge);
    }
    output::write_text(
        settings_.output / conditions_,
        output::conditions({"both sides at 0.1 ms, fastest-first, speeds of degree 2, mean torque",
                            "largest difference of the pitch at the kart's steps",
                            "one run (multirate, schemes, and work from 2 s on), the least of 2 (work)"})
                .dump(2) +
            "\n");
    if (context_.quiet) return;
    say("{}{}", kart::multirate_head, multirate_lines_);
    for (const std::string& name : names_) say("wrote {}\n", (settings_.output / name).string());
  }

 private:
  enum Table : std::size_t { multirate, schemes, shares, work, traces };  ///< in this order in tables_

  std::size_t size() {
    if (levels_.empty()) levels_.assign(std::begin(kart::levels), std::end(kart::levels));
    const std::size_t more =
        settings_.only_table ? 0 : kart::work_schemes().size() * std::size(kart::work_ratios);
    return levels_.size() * (std::size(kart::ratios) + schemes_.size() + more);
  }

  void open(const std::string& name, const std::string& header) {
    names_.push_back(name);
    tables_.emplace_back(settings_.output / name, header);
  }

  void add_multirate(kart::Judge& judge) {
    double seconds = 0.0;
    for (const int ratio : kart::ratios) {
      const kart::Outcome o =
          ratio == 1 ? judge.judge_thesis() : judge.judge(ratio, kart::thesis_scheme, true);
      if (ratio == 1) seconds = o.course.seconds;
      tables_[shares].add(kart::shares_row(judge.level(), ratio, o.course));
      multirate_lines_ += kart::multirate_line(judge.level(), ratio, seconds, o);
      add(multirate, kart::multirate_row(judge.level(), ratio, seconds, o));
    }
  }

  void add_schemes(kart::Judge& judge) {
    constexpr int ratio = 100;
    kart::Extremes extremes;
    for (const kart::Scheme& scheme : schemes_) {
      const kart::Outcome o = judge.judge(ratio, scheme, false);
      extremes.add(scheme, o);
      add(schemes, kart::scheme_row(judge.level(), ratio, scheme, o));
    }
    if (settings_.only_table) return;
    std::string rows = kart::trace_rows(judge, extremes);
    rows.pop_back();  // the last line's end
    tables_[traces].add(std::move(rows));
  }

  void add_work(kart::Judge& judge) {
    for (const int ratio : kart::work_ratios)
      for (const kart::Scheme& scheme : kart::work_schemes()) add(work, kart::work_row(judge, ratio, scheme));
  }

  void add(std::size_t table, const std::string& row) {
    tables_[table].add(row);
    progress_.update(++done_);
    if (InterruptGuard::interrupted())
      throw RunFailed(fmt::format("interrupted; {} of {} rows are in the tables of {}", done_, size(),
                                  settings_.output.string()));
  }

  static constexpr const char* conditions_ = "conditions.json";  // there when all else is
  const KeptFolder folder_;
  const KartSweep& settings_;
  const Context& context_;
  kart::Scene scene_;
  std::vector<kart::Scheme> schemes_;
  std::vector<std::string> levels_;
  std::vector<std::string> names_;
  std::deque<output::OrderedRows> tables_;
  std::string multirate_lines_;
  Progress progress_;
  std::size_t done_ = 0;
};

}  // namespace

void sweep_kart(const KartSweep& settings, const Context& context) {
  const InterruptGuard guard;
  KartRuns(settings, context).make();
}

}  // namespace tandem::cli
