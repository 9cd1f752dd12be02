// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/sweep.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "cli/sweep_engine.hpp"
#include "cli/sweep_engine_linkage.hpp"
#include "cli/sweep_four_bar.hpp"
#include "cli/sweep_kart.hpp"
#include "cli/sweep_kart_drive.hpp"
#include "cli/sweep_mechanisms.hpp"
#include "cli/sweep_split_pendulum.hpp"
#include "cli/sweep_study.hpp"
#include "output/conditions.hpp"
#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/provenance.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

constexpr int work_repetitions = 5;
constexpr std::uint64_t longest_settings = 1U << 20;  // bytes

struct SweepOptions {
  std::string scene;
  fs::path output, mechanisms = "scenarios/mechanisms", engine_linkage = "scenarios/engine_linkage",
                   engine = "scenarios/engine", kart = "scenarios/kart";
  std::vector<std::string> levels, overrides;
  bool pairs = false, resume = false, only_table = false, dry = false;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

std::vector<two_mass::Case> cases_of(const SweepOptions& options) {
  std::vector<two_mass::Case> cases;
  for (const double ratio : two_mass::sweep_ratios())
    for (const auto& scheme : two_mass::sweep_schemes(options.pairs)) cases.push_back({scheme, ratio});
  return cases;
}

/// What a sweep that is resumed must agree on with the one before.
std::string settings() {
  const nlohmann::ordered_json json{{"scene", "two_mass"},
                                    {"cycles", two_mass::Case{}.cycles},
                                    {"steps_per_cycle", two_mass::Case{}.steps_per_cycle},
                                    {"version", output::version()},
                                    {"commit", output::source_commit()}};
  return json.dump(2) + "\n";
}

/// A sweep from its folder to its tables. sweep.json says what made them; conditions.json stands there when
/// all are complete.
class TwoMassSweep {
 public:
  TwoMassSweep(const SweepOptions& options, const Context& context)
      : folder_(options.output), options_(options), context_(context) {
    if (!options.resume || !made_alike())
      for (const char* name : {"sweep.csv", "sweep_timings.csv", "work.csv", "traces.csv"})
        fs::remove(options.output / name);
    fs::remove(options.output / "conditions.json");
    output::write_text(options.output / "sweep.json", settings());
  }

  void make() {
    try {
      make_table();
      if (!options_.only_table) make_the_rest();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::input_output) throw;
      throw RunFailed(error.what());  // begun and not ended: a full disk, say
    }
    if (!context_.quiet) say("wrote {}\n", (options_.output / "sweep.csv").string());
  }

 private:
  bool made_alike() const {
    const fs::path file = options_.output / "sweep.json";
    if (!fs::exists(file)) return false;
    const std::string before = read_file(file, longest_settings);
    if (before != settings())
      spdlog::info("The sweep in {} was made by other code or with other settings; it is made anew.",
                   options_.output.string());
    return before == settings();
  }

  void read(const char* name, output::KeyedTable& table) const {
    if (fs::exists(options_.output / name)) table.read(options_.output / name);
  }

  void make_table() const {
    const auto cases = cases_of(options_);
    std::vector<std::string> keys;
    for (const auto& c : cases) keys.push_back(two_mass::sweep_key(c));
    auto rows = two_mass::sweep_table(), timings = two_mass::timing_table();
    read("sweep.csv", rows);
    read("sweep_timings.csv", timings);
    spdlog::debug("sweep: {} of {} rows are there; {} threads", rows.size(), cases.size(), options_.threads);
    Progress progress("sweep", cases.size(), !context_.quiet);
    two_mass::run_sweep({cases, options_.threads, rows, timings}, [&](std::size_t done) {
      progress.update(done);
      return !InterruptGuard::interrupted();
    });
    rows.write(options_.output / "sweep.csv", keys);
    timings.write(options_.output / "sweep_timings.csv", keys);
    keep_going(rows, keys, "sweep.csv");
  }

  /// What the charts need besides. Run times are taken one case at a time, so that they mean something.
  void make_the_rest() const {
    if (!fs::exists(options_.output / "traces.csv")) two_mass::write_traces(options_.output / "traces.csv");
    const auto cases = two_mass::work_cases();
    std::vector<std::string> keys;
    for (const auto& c : cases) keys.push_back(two_mass::work_key(c));
    auto rows = two_mass::work_table();
    read("work.csv", rows);
    Progress progress("work ", cases.size(), !context_.quiet);
    for (std::size_t i = 0; i < cases.size() && !InterruptGuard::interrupted(); ++i) {
      if (!rows.has(keys[i])) rows.set(keys[i], two_mass::work_cells(cases[i], work_repetitions));
      progress.update(i + 1);
    }
    rows.write(options_.output / "work.csv", keys);
    keep_going(rows, keys, "work.csv");
    output::write_text(options_.output / "conditions.json",
                       output::conditions(work_repetitions).dump(2) + "\n");
  }

  void keep_going(const output::KeyedTable& rows, const std::vector<std::string>& keys,
                  const char* name) const {
    const auto done = static_cast<std::size_t>(
        std::count_if(keys.begin(), keys.end(), [&](const std::string& key) { return rows.has(key); }));
    if (done < keys.size())
      throw RunFailed(fmt::format("interrupted; {} of {} rows are kept in {}, --resume goes on from there",
                                  done, keys.size(), (options_.output / name).string()));
  }

  const InterruptGuard guard_;  // from before the first file is written
  const KeptFolder folder_;
  const SweepOptions& options_;
  const Context& context_;
};

}  // namespace

void add_sweep(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("sweep", "Run a scene over its schemes and frequency ratios, and write the table");
  auto options = std::make_shared<SweepOptions>();
  command
      ->add_option(
          "study", options->scene,
          "A study, a TOML file (docs/studies.md); or a scene of tandem's own: two_mass; split_pendulum; "
          "engine (torque map, step response, changes of gear); "
          "engine_linkage (the linkage driven by the engine, every scheme); kart (with its engine, every "
          "level, step and scheme); kart_drive (the torque of its engine over the manoeuvre, from level ii "
          "as "
          "one system: drive.csv); mechanisms (every formulation and integrator on every example); or "
          "four_bar "
          "(the N-fold four-bar linkage through its flat position)")
      ->required()
      ->check(CLI::IsMember({"two_mass", "split_pendulum", "engine", "engine_linkage", "kart", "kart_drive",
                             "mechanisms", "four_bar"}) |
              CLI::ExistingFile);
  command
      ->add_option("--set", options->overrides,
                   "Of a study: set a value of its scenario, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->add_flag("--dry-run", options->dry,
                    "Of a study: tell its rows, its references and what is refused, and run nothing");
  command
      ->add_option("--output", options->output,
                   "Folder for the tables (default: results/SCENE; for mechanisms and four_bar results/mbs)")
      ->type_name("DIR");
  command
      ->add_option("--mechanisms", options->mechanisms,
                   "Folder of the example mechanisms (default: scenarios/mechanisms)")
      ->type_name("DIR");
  command
      ->add_option("--engine-linkage", options->engine_linkage,
                   "Folder of that scene (default: scenarios/engine_linkage)")
      ->type_name("DIR");
  command->add_option("--kart", options->kart, "Folder of that scene (default: scenarios/kart)")
      ->type_name("DIR");
  command
      ->add_option("--engine", options->engine, "Folder of the engine's diagrams (default: scenarios/engine)")
      ->type_name("DIR");
  command
      ->add_option(
          "--level", options->levels,
          "A level of the kart: point, plane, spatial_scalar_spin, spatial (repeatable; default: all)")
      ->expected(1)
      ->take_all()
      ->check(CLI::IsMember({"point", "plane", "spatial_scalar_spin", "spatial"}));
  command->add_flag("--pairs", options->pairs, "All 25 pairs of degrees, not only equal ones");
  command->add_flag("--resume", options->resume,
                    "Keep the rows that are there from a sweep that was stopped, if the same code made them");
  command->add_flag("--table-only", options->only_table,
                    "Leave out what only the charts need (traces, run times)");
  command->add_option("--threads", options->threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1U, 1024U));
  command->footer(
      "A scenario is code: the programs and libraries that those of the folders name are run with your "
      "rights.");
  command->callback([options, &context] {
    const std::string& scene = options->scene;
    if (fs::is_regular_file(scene))
      return sweep_study(
          {scene, options->output, options->overrides, options->threads, options->resume, options->dry},
          context);
    if (options->output.empty())
      options->output = fs::path("results") / (scene == "mechanisms" || scene == "four_bar" ? "mbs"
                                               : scene == "kart_drive"                      ? "kart"
                                                                                            : scene);
    if (scene == "mechanisms")
      sweep_mechanisms({options->mechanisms, options->output, options->threads, options->only_table},
                       context);
    else if (scene == "four_bar")
      sweep_four_bar(options->output, options->threads, context);
    else if (scene == "kart_drive")
      sweep_kart_drive(options->output, context);
    else if (scene == "engine")
      sweep_engine(options->engine, options->output, context);
    else if (scene == "engine_linkage")
      sweep_engine_linkage({options->engine_linkage, options->output, options->threads, options->only_table},
                           context);
    else if (scene == "kart")
      sweep_kart({options->kart, options->output, options->levels, options->only_table}, context);
    else if (scene == "split_pendulum")
      sweep_split_pendulum(options->output, options->threads, context);
    else
      TwoMassSweep(*options, context).make();
  });
}

}  // namespace tandem::cli
