// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <nlohmann/json.hpp>

#include "choices.hpp"
#include "fingerprint.hpp"
#include "hand_out.hpp"
#include "norm_text.hpp"
#include "one_at_a_time.hpp"
#include "plan.hpp"
#include "row_key.hpp"
#include "series.hpp"
#include "table_rows.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"
#include "tandem/output/lock.hpp"
#include "tandem/output/parallel.hpp"
#include "told_reference.hpp"

namespace tandem::study {
namespace fs = std::filesystem;

/// The file is long, as all steps of a sweep share its rows, references and runners.
class Sweep::Work {
 public:
  Work(const Study& study, const Builtins& builtins, SweepSettings settings)
      : study_(study),
        settings_(std::move(settings)),
        scenes_(study, builtins, settings_.overrides),
        references_(study, scenes_, builtins),
        builtins_(builtins),
        threads_(settings_.threads) {
    for (const Table& table : study.tables)
      runners_.emplace_back(study, table, scenes_, references_, builtins, settings_.metrics);
    if (!is_helper()) read_scenarios();
  }

  std::vector<std::string> plan() { return study::plan(study_, runners_, references_); }

  SweepEnd run(const SweepListener& listener) {
    listener_ = &listener;
    if (is_helper()) return work_for_rank_0(), SweepEnd();
    if (settings_.ranks) hand_out_ = std::make_unique<HandOut>(*settings_.ranks);
    const output::FolderLock kept(settings_.folder,
                                  [this](const std::string& note) { end_.notes.push_back(note); });
    take_units();
    take_threads();
    begin();
    make_references();
    run_rows(open_, at_a_time());
    run_rows(timed_, 1);
    refuse_if_all_are();
    if (!end_.interrupted) finish();
    if (!end_.interrupted) write_series();
    for (TableRows& rows : rows_)
      if (!end_.interrupted) rows.remove_part();
    return std::move(end_);
  }

 private:
  using Going = std::function<bool()>;
  struct Job {
    std::size_t table;
    const FileValues* row;
  };

  bool is_helper() const { return settings_.ranks && settings_.ranks->rank() != 0; }
  bool going() const { return !listener_->going || listener_->going(); }

  /// All of them, so that what one does not take is told before any runs.
  void read_scenarios() {
    fingerprint_.add(study_.file);
    for (const Table& table : study_.tables)
      for (const FileValues& row : table.rows) fingerprint_.add(scenes_.of_row(table, row));
  }

  /// By the first row of each table that is not refused: this finds outputs that are not there too.
  void take_units() {
    for (std::size_t k = 0; k < runners_.size(); ++k) {
      units_.emplace_back();
      for (const FileValues& row : study_.tables[k].rows)
        if (units_.back() = runners_[k].units(row); !units_.back().empty()) break;
    }
  }

  void take_threads() {
    if (settings_.ranks || threads_ == 1) return;
    const std::string note = one_at_a_time(study_, scenes_, builtins_);
    if (!note.empty()) threads_ = 1, end_.notes.push_back(note);
  }

  /// All that rows need, whether they are kept or not.
  void need_references() {
    for (std::size_t k = 0; k < runners_.size(); ++k)
      for (const FileValues& row : study_.tables[k].rows)
        references_.need(runners_[k].metrics(), study_.tables[k], row);
    for (std::size_t k = 0; k < references_.size(); ++k)
      if (const ReferenceRun& run = references_.run(k); run.reference->file.empty())
        fingerprint_.add(scenes_.of_reference(*run.reference, *run.table, run.per, run.columns));
      else
        fingerprint_.add(run.reference->file);
  }

  void begin() {
    need_references();
    const std::string made_from = fingerprint_.text(settings_.overrides, study_.seed);
    bool other = false;
    for (std::size_t k = 0; k < runners_.size(); ++k) {
      TableRows& rows = rows_.emplace_back(study_.tables[k], study_.columns_of(study_.tables[k]),
                                           settings_.folder, made_from);
      if (settings_.resume && !rows.keep()) other = true;
      end_.kept += rows.size();
      end_.rows += study_.tables[k].rows.size();
      for (const FileValues& row : study_.tables[k].rows)
        if (!rows.has(row)) (study_.is_timed(study_.tables[k]) ? timed_ : open_).push_back({k, &row});
    }
    if (other)
      end_.notes.emplace_back(
          "the rows in the folder are of another study, scenario or program; they are made anew");
    for (TableRows& rows : rows_) {
      for (const fs::path& file : {rows.file(), rows.json(), rows.series()}) remove_earlier(file);
      rows.begin();
    }
    for (const Choice& choice : study_.choices) remove_earlier(file_of(choice));
  }

  /// Nobody takes it for that of this sweep.
  static void remove_earlier(const fs::path& file) {
    if (fs::is_regular_file(file)) fs::remove(file);
  }
  fs::path file_of(const Choice& choice) const { return settings_.folder / (choice.name + ".csv"); }

  /// here: does a job; job and done: what another rank is told of it, and has answered. most: jobs at a time.
  void in_parallel(const char* what, std::size_t count, unsigned most,
                   const std::function<void(std::size_t, const Going&)>& here,
                   const std::function<Told(std::size_t)>& job,
                   const std::function<void(std::size_t, const Told&)>& done) {
    if (count == 0) return;
    std::atomic<bool> stop = false;
    const auto tick = [&](std::size_t finished) {
      if (listener_->come) listener_->come(what, finished, count);
      if (!going()) stop = true, end_.interrupted = true;
      return !stop.load();
    };
    if (hand_out_) return hand_out_->each(count, most, job, done, tick);
    output::for_each_in_parallel(
        count, most, [&](std::size_t k) { here(k, [&] { return !stop; }); }, tick);
  }

  unsigned at_a_time() const { return hand_out_ ? static_cast<unsigned>(settings_.ranks->size()) : threads_; }

  void make_references() {
    if (open_.empty() && timed_.empty() && study_.kept.empty()) return;
    in_parallel(
        "references", references_.size(), at_a_time(),
        [&](std::size_t k, const Going& go_on) { references_.make(k, go_on); },
        [](std::size_t k) {
          return Told{{"reference", k}};
        },
        [&](std::size_t k, const Told& made) {
          take(made, references_.run(k));
          hand_out_->tell_all({{"take", k}, {"made", made}});
        });
    for (std::size_t k = 0; k < references_.size() && !end_.interrupted; ++k)
      if (const std::string& failure = references_.run(k).failure; !failure.empty())
        end_.notes.push_back(failure), end_.reference_failed = true;
  }

  void run_rows(const std::vector<Job>& jobs, unsigned most) {
    if (end_.interrupted) return;
    const auto take_row = [&](std::size_t k, const Told& answer) {
      const auto& [table, row] = jobs[k];
      rows_[table].add(*row, answer["line"]);
      note(table, *row, answer["status"], answer["note"]);
    };
    in_parallel(
        &jobs == &timed_ ? "timed rows" : "rows", jobs.size(), most,
        [&](std::size_t k, const Going& go_on) {
          if (const Told answer = run_row(jobs[k], go_on); !answer.is_null()) take_row(k, answer);
        },
        [&](std::size_t k) {
          const auto row = jobs[k].row - study_.tables[jobs[k].table].rows.data();
          return Told{{"table", jobs[k].table}, {"row", row}};
        },
        take_row);
    end_.done = end_.kept;
    for (const auto& [status, count] : end_.statuses) end_.done += count;
  }

  /// Null: `go_on` said no.
  Told run_row(const Job& job, const Going& go_on) const {
    const auto result = runners_[job.table].run(*job.row, go_on);
    if (!result) return {};
    return {{"line", rows_[job.table].line(*job.row, *result)},
            {"status", result->status},
            {"note", result->note}};
  }

  void work_for_rank_0() {
    need_references();
    for (const Table& table : study_.tables)
      rows_.emplace_back(table, study_.columns_of(table), settings_.folder, "");
    work_for(
        *settings_.ranks, [this](const Told& job, const Going& go_on) { return answer(job, go_on); },
        [this] { return going(); });
  }

  Told answer(const Told& job, const Going& go_on) {
    if (job.contains("take")) return take(job["made"], references_.run(job["take"])), Told();
    Told answer;
    if (job.contains("reference")) {
      references_.make(job["reference"], go_on);
      if (go_on()) answer = told(references_.run(job["reference"]));
    } else {
      const std::size_t table = job["table"];
      answer = run_row({table, &study_.tables[table].rows[job["row"].get<std::size_t>()]}, go_on);
    }
    if (answer.is_null())
      throw Error(ErrorCode::input_output, fmt::format("rank {} was interrupted", settings_.ranks->rank()));
    return answer;
  }

  void note(std::size_t table, const FileValues& row, const std::string& status, const std::string& why) {
    const std::lock_guard lock(mutex_);
    ++end_.statuses[status];
    if (status == "refused" && refusal_.empty())
      refusal_ = "(" + row_text(study_.tables[table].columns, row) + ") " + why;
  }

  void refuse_if_all_are() {
    if (end_.rows == 0 || end_.statuses["refused"] < end_.rows) return;
    for (TableRows& rows : rows_) rows.remove_part();
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: all {} rows are refused, as {}", study_.file.string(), end_.rows, refusal_));
  }

  void finish() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      rows_[k].finish();
      output::replace_text(rows_[k].json(), about(k).dump(2) + '\n');
      end_.files.push_back(rows_[k].file());
      end_.files.push_back(rows_[k].json());
    }
    for (const Choice& choice : study_.choices) {
      output::replace_text(file_of(choice), choices_text(choice, study_, settings_.folder));
      end_.files.push_back(file_of(choice));
    }
  }

  /// Of runs that are made again, so that rows that were kept need not be.
  void write_series() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      Series series(study_, study_.tables[k], references_);
      if (series.empty()) continue;
      const auto text = series.text(rows_[k].file(), runners_[k], [this] { return going(); });
      if (!text) return void(end_.interrupted = true);
      output::replace_text(rows_[k].series(), *text);
      units_[k].insert(series.units().begin(), series.units().end());
      output::replace_text(rows_[k].json(), about(k).dump(2) + '\n');
      end_.files.push_back(rows_[k].series());
    }
  }

  nlohmann::ordered_json about(std::size_t table) const {
    nlohmann::ordered_json references = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < references_.size(); ++k) references.push_back(references_.run(k).text());
    return {{"study", study_.file.string()},
            {"table", study_.tables[table].name},
            {"units", units_[table]},
            {"references", references},
            {"norms", norms(study_.tables[table])},
            {"made_from", fingerprint_.text(settings_.overrides, study_.seed)},
            {"made", output::made()}};
  }

  std::map<std::string, std::string> norms(const Table& table) const {
    std::map<std::string, std::string> norms;
    for (const std::string& name : table.metrics)
      if (std::string text = norm_text(study_.metric(name)); !text.empty()) norms[name] = std::move(text);
    return norms;
  }

  const Study& study_;
  const SweepSettings settings_;
  Scenes scenes_;
  References references_;
  const Builtins& builtins_;
  unsigned threads_;               ///< rows that run at the same time, without ranks
  std::deque<RowRunner> runners_;  ///< by table
  std::deque<TableRows> rows_;
  std::vector<std::map<std::string, std::string>> units_;
  Fingerprint fingerprint_;
  std::vector<Job> open_, timed_;  ///< rows that are not there yet; timed_: one at a time
  const SweepListener* listener_ = nullptr;
  std::unique_ptr<HandOut> hand_out_;  ///< of rank 0, if there are ranks
  std::mutex mutex_;
  std::string refusal_;
  SweepEnd end_;
};

Sweep::Sweep(const Study& study, const Builtins& builtins, SweepSettings settings)
    : work_(std::make_unique<Work>(study, builtins, std::move(settings))) {}
Sweep::~Sweep() = default;
std::vector<std::string> Sweep::plan() { return work_->plan(); }
SweepEnd Sweep::run(const SweepListener& listener) { return work_->run(listener); }

}  // namespace tandem::study
