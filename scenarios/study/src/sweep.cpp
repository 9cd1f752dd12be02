// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <nlohmann/json.hpp>

#include "fingerprint.hpp"
#include "norm_text.hpp"
#include "row_key.hpp"
#include "series.hpp"
#include "table_rows.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"
#include "tandem/output/lock.hpp"
#include "tandem/output/parallel.hpp"

namespace tandem::study {
namespace fs = std::filesystem;

class Sweep::Work {
 public:
  Work(const Study& study, const Builtins& builtins, SweepSettings settings)
      : study_(study),
        settings_(std::move(settings)),
        scenes_(study, builtins, settings_.overrides),
        references_(study, scenes_, builtins) {
    for (const Table& table : study.tables)
      runners_.emplace_back(study, table, scenes_, references_, builtins, settings_.metrics);
    read_scenarios();
  }

  std::vector<std::string> plan() {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < runners_.size(); ++k) {
      const Table& table = study_.tables[k];
      lines.push_back(fmt::format("{}.csv: {} rows", table.name, table.rows.size()));
      for (const FileValues& row : table.rows) {
        references_.need(runners_[k].metrics(), study_.tables[k], row);
        if (const std::string why = runners_[k].refusal(row); !why.empty())
          lines.push_back("  refused (" + row_text(table.columns, row) + "): " + why);
      }
    }
    for (std::size_t k = 0; k < references_.size(); ++k)
      lines.push_back(references_.run(k).text() +
                      (references_.run(k).reference->floor ? ", and with half its steps" : ""));
    return lines;
  }

  SweepEnd run(const SweepListener& listener) {
    const output::FolderLock kept(settings_.folder,
                                  [this](const std::string& note) { end_.notes.push_back(note); });
    listener_ = &listener;
    take_units();
    begin();
    make_references();
    run_rows(open_, settings_.threads);
    run_rows(timed_, 1);
    refuse_if_all_are();
    if (!end_.interrupted) finish();
    if (!end_.interrupted) write_series();
    for (TableRows& rows : rows_)
      if (!end_.interrupted) rows.remove_part();
    return std::move(end_);
  }

 private:
  struct Job {
    std::size_t table;
    const FileValues* row;
  };

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
    const std::string made_from = fingerprint_.text(settings_.overrides);
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
    for (TableRows& rows : rows_) remove_earlier(rows), rows.begin();
  }

  /// Nobody takes them for those of this sweep.
  static void remove_earlier(const TableRows& rows) {
    for (const fs::path& file : {rows.file(), rows.json(), rows.series()})
      if (fs::is_regular_file(file)) fs::remove(file);
  }

  template <class One>
  void in_parallel(const char* what, std::size_t count, unsigned threads, const One& one) {
    if (count == 0) return;
    std::atomic<bool> stop = false;
    const auto go_on = [&] { return !stop; };
    output::for_each_in_parallel(
        count, threads, [&](std::size_t k) { one(k, go_on); },
        [&](std::size_t done) {
          if (listener_->come) listener_->come(what, done, count);
          if (!going()) stop = true, end_.interrupted = true;
          return !stop.load();
        });
  }

  void make_references() {
    if (open_.empty() && timed_.empty() && study_.kept.empty()) return;
    in_parallel("references", references_.size(), settings_.threads,
                [&](std::size_t k, const std::function<bool()>& go_on) { references_.make(k, go_on); });
    for (std::size_t k = 0; k < references_.size() && !end_.interrupted; ++k)
      if (const std::string& failure = references_.run(k).failure; !failure.empty())
        end_.notes.push_back(failure), end_.reference_failed = true;
  }

  void run_rows(const std::vector<Job>& jobs, unsigned threads) {
    if (end_.interrupted) return;
    const char* what = &jobs == &timed_ ? "timed rows" : "rows";
    in_parallel(what, jobs.size(), threads, [&](std::size_t k, const std::function<bool()>& go_on) {
      const auto& [table, row] = jobs[k];
      if (const auto result = runners_[table].run(*row, go_on)) {
        rows_[table].add(*row, *result);
        note(table, *row, *result);
      }
    });
    end_.done = end_.kept;
    for (const auto& [status, count] : end_.statuses) end_.done += count;
  }

  void note(std::size_t table, const FileValues& row, const RowResult& result) {
    const std::lock_guard lock(mutex_);
    ++end_.statuses[result.status];
    if (result.status == "refused" && refusal_.empty())
      refusal_ = "(" + row_text(study_.tables[table].columns, row) + ") " + result.note;
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
  }

  /// Of runs that are made again, so that rows that were kept need not be.
  void write_series() {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const Series series(study_, study_.tables[k], references_);
      if (series.empty()) continue;
      const auto text = series.text(rows_[k].file(), runners_[k], [this] { return going(); });
      if (!text) return void(end_.interrupted = true);
      output::replace_text(rows_[k].series(), *text);
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
            {"made_from", fingerprint_.text(settings_.overrides)},
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
  std::deque<RowRunner> runners_;  ///< by table
  std::deque<TableRows> rows_;
  std::vector<std::map<std::string, std::string>> units_;
  Fingerprint fingerprint_;
  std::vector<Job> open_, timed_;  ///< rows that are not there yet; timed_: one at a time
  const SweepListener* listener_ = nullptr;
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
