// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/chart_scenes.hpp"

#include "charts/dense_chart.hpp"
#include "charts/elsewhere_chart.hpp"
#include "charts/flat_position_chart.hpp"
#include "charts/ladder_chart.hpp"
#include "charts/linkage_cost_chart.hpp"
#include "charts/linkage_errors_chart.hpp"
#include "charts/mechanisms_work_chart.hpp"
#include "charts/simbody_chart.hpp"
#include "charts/solver_map_chart.hpp"
#include "charts/threads_chart.hpp"
#include "charts/transports_chart.hpp"
#include "tandem/charts/style.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;
using charts::conditions_caption;

Drawing mechanisms(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "work_conditions.json", 180);
  return {{charts::mechanisms_work_chart(charts::read_formulation_work(folder / "work.csv"), caption)}, ""};
}

Drawing four_bar(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "four_bar_conditions.json", 150);
  return {{charts::linkage_errors_chart(charts::read_linkage_errors(folder / "four_bar.csv"), caption),
           charts::flat_position_chart(charts::read_passages(folder / "four_bar_traces.csv"), caption)},
          ""};
}

Drawing four_bar_cost(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "four_bar_conditions.json", 150);
  return {{charts::linkage_cost_chart(charts::read_linkage_times(folder / "four_bar.csv"), caption)}, ""};
}

Drawing ladder(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "conditions.json", 150);
  return {{charts::ladder_chart(charts::read_ladder(folder / "ladder.csv"), caption)}, ""};
}

Drawing solvers(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "solvers_conditions.json", 140);
  return {{charts::solver_map_chart(charts::read_solver_times(folder / "solvers.csv"), caption)}, ""};
}

Drawing dense(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "dense_conditions.json", 150);
  return {{charts::dense_chart(charts::read_dense_times(folder / "dense.csv"), caption)}, ""};
}

Drawing threads(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "threads_conditions.json", 150);
  return {{charts::threads_chart(charts::read_thread_times(folder / "threads.csv"), caption)}, ""};
}

Drawing transports(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "transports_conditions.json", 150);
  return {{charts::transports_chart(charts::read_transport_times(folder / "transports.csv"), caption)}, ""};
}

Drawing engine_linkage_elsewhere(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "engine_linkage_conditions.json", 150);
  return {{charts::elsewhere_chart(charts::read_elsewhere_times(folder / "engine_linkage.csv"), caption)},
          ""};
}

Drawing simbody(const fs::path& folder) {
  const auto caption = conditions_caption(folder / "simbody_conditions.json", 180);
  const auto runs = charts::read_linkage_runs(folder / "simbody.csv");
  return {{charts::simbody_chart(runs, caption)}, charts::ratios(runs)};
}

const ChartScene scenes[] = {
    {"mechanisms",
     "results/mbs",
     "sweep mechanisms --output {}",
     {"work.csv", "work_conditions.json"},
     mechanisms},
    {"four_bar",
     "results/mbs",
     "sweep four_bar --output {}",
     {"four_bar.csv", "four_bar_traces.csv", "four_bar_conditions.json"},
     four_bar},
    {"four_bar_cost",
     "results/bench",
     "bench four_bar --output {}",
     {"four_bar.csv", "four_bar_conditions.json"},
     four_bar_cost},
    {"ladder",
     "results/ladder/kart",
     "ladder SCENARIO --output {}",
     {"ladder.csv", "conditions.json"},
     ladder},
    {"solvers",
     "results/bench",
     "bench solvers --output {}",
     {"solvers.csv", "solvers_conditions.json"},
     solvers},
    {"dense", "results/bench", "bench dense --output {}", {"dense.csv", "dense_conditions.json"}, dense},
    {"threads",
     "results/bench",
     "bench threads --output {}",
     {"threads.csv", "threads_conditions.json"},
     threads},
    {"transports",
     "results/bench",
     "bench transports --output {}",
     {"transports.csv", "transports_conditions.json"},
     transports},
    {"engine_linkage_elsewhere",
     "results/bench",
     "bench engine_linkage --output {}",
     {"engine_linkage.csv", "engine_linkage_conditions.json"},
     engine_linkage_elsewhere},
    {"simbody",
     "results/bench",
     "bench simbody --output {}",
     {"simbody.csv", "simbody_conditions.json"},
     simbody}};

}  // namespace

std::span<const ChartScene> chart_scenes() { return scenes; }

}  // namespace tandem::cli
