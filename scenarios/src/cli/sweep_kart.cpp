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

class KartRuns {
 public:
  KartRuns(const KartSweep& settings, const Context& context)
      : settings_(settings),
        context_(context),
        scene_{settings.scene, context.builtins},
        schemes_(kart::schemes()),
        progress_("sweep", std::size(kart::levels) * (std::size(kart::ratios) + schemes_.size()),
                  !context.quiet) {}

  void make() {
    output::make_folder(settings_.output);
    std::string multirate = std::string(kart::multirate_header) + "\n",
                table = std::string(kart::schemes_header) + "\n";
    for (const char* level : kart::levels) {
      kart::Judge judge(scene_, level);
      multirate += multirate_rows(judge);
      table += scheme_rows(judge);
    }
    output::write_text(settings_.output / "multirate.csv", multirate);
    output::write_text(settings_.output / "schemes.csv", table);
    output::write_text(
        settings_.output / "conditions.json",
        output::conditions({"both sides at 0.1 ms, fastest-first, speeds of degree 2, mean torque",
                            "largest difference of the pitch at the kart's steps", "one run"})
                .dump(2) +
            "\n");
    if (!context_.quiet)
      for (const char* name : {"multirate.csv", "schemes.csv"})
        fmt::print("wrote {}\n", (settings_.output / name).string());
  }

 private:
  std::string multirate_rows(kart::Judge& judge) {
    std::string rows;
    double seconds = 0.0;
    for (const int ratio : kart::ratios) {
      const kart::Outcome o =
          ratio == 1 ? judge.judge_thesis() : judge.judge(ratio, kart::thesis_scheme, true);
      if (ratio == 1) seconds = o.course.seconds;
      rows += kart::multirate_row(judge.level(), ratio, seconds, o) + "\n";
      one_more();
    }
    return rows;
  }

  std::string scheme_rows(kart::Judge& judge) {
    constexpr int ratio = 100;
    std::string rows;
    for (const kart::Scheme& scheme : schemes_) {
      rows += kart::scheme_row(judge.level(), ratio, scheme, judge.judge(ratio, scheme, false)) + "\n";
      one_more();
    }
    return rows;
  }

  void one_more() {
    if (InterruptGuard::interrupted()) throw RunFailed("interrupted; nothing more is written");
    progress_.update(++done_);
  }

  const KartSweep& settings_;
  const Context& context_;
  kart::Scene scene_;
  std::vector<kart::Scheme> schemes_;
  Progress progress_;
  std::size_t done_ = 0;
};

}  // namespace

void sweep_kart(const KartSweep& settings, const Context& context) {
  const InterruptGuard guard;
  KartRuns(settings, context).make();
}

}  // namespace tandem::cli
