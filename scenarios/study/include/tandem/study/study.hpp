// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tandem/charts/chart.hpp"
#include "tandem/study/metric.hpp"
#include "tandem/text/key_list.hpp"

namespace tandem::study {

/// The largest or smallest value of a column for which a condition holds, found by bisection.
struct Search {
  std::string column;
  double from, to;   ///< Between these.
  bool largest;      ///< It holds at `from`, and up to the value that is found; else from there to `to`.
  Formula holds;     ///< Of metrics and columns; a run with another status than ok never does.
  double precision;  ///< Relative, of the value.
  std::optional<double> scan =
      {};  ///< The first value for which it does not hold, on the way by this factor.
  std::optional<double> nowhere = {},
                        everywhere = {};  ///< In place of the value where it holds nowhere, everywhere.
};

/// Rows of one set of columns.
struct Table {
  std::string name;
  std::vector<std::string> columns;  ///< that tell its rows apart
  std::vector<std::string> metrics;  ///< that it has
  std::vector<std::string> header;   ///< columns and metrics in the order in which they are written
  std::vector<FileValues> rows;      ///< by column
  Place place;
  std::optional<Search> search = {};   ///< each row is a search; its column is a metric of the row
  std::optional<Given> scenario = {};  ///< in place of the study's
  std::vector<Given> set = {};         ///< besides what the study sets; with a scenario of its own alone
  bool models = false;                 ///< linear models run in its subsystems' places
};

/// The row that one table chooses, for each of the values of some columns, and what another one with the same rows says
/// of it: how good advice is, say.
struct Choice {
  std::string name;                      ///< it is written to NAME.csv
  std::string by, of;                    ///< the table that chooses, and the one that judges
  std::string least, cost;               ///< metrics of `by`
  std::string error;                     ///< a metric of `of`
  std::vector<std::string> per;          ///< a choice for each of the values of these columns
  static constexpr double alike = 1.01;  ///< of the rows with so many times the least the cheapest is chosen
  Place place = {};
};

/// What results are compared with: results, or a run.
struct Reference {
  std::string name;
  std::filesystem::path file = {};                  ///< Of results; empty: a run.
  std::optional<Given> scenario = {};               ///< Of the run; none: that of the study.
  std::vector<std::string> per = {};                ///< Columns: one run for each of the values of a table's.
  std::vector<Given> with = {};                     ///< Values of other columns in it.
  std::vector<Given> set = {};                      ///< Besides what the study sets.
  std::map<std::string, std::string> outputs = {};  ///< Of judged outputs the ones with another name in it.
  bool models = false;                              ///< Linear models run in its subsystems' places.
  bool floor = false;                               ///< Its own error is told, by a run with half its steps.
  Place place = {};
};

/// Runs of a table whose outputs over time are kept, in TABLE.series.csv.
struct Kept {
  std::string name;  ///< In the column `kept`.
  std::string table;
  std::optional<Formula> where = {};      ///< Of columns and metrics.
  std::string least = {}, most = {};      ///< The metric by which one of them is chosen; empty: all.
  std::vector<std::string> per = {};      ///< One for each of the values of these columns.
  std::vector<std::string> outputs;       ///< The first gives the times.
  std::vector<std::string> metrics = {};  ///< Signals and drifts, over time.
  std::string against = {};               ///< A reference whose outputs stand beside them; empty: none.
  double every = 0.0;                     ///< Between two rows, at least [s].
  Place place = {};
};

/// Runs of a scenario with columns of values, what each is judged by, and what they are compared with.
struct Study {
  std::filesystem::path file;
  std::uint64_t seed;          ///< of values that are drawn
  Given scenario;              ///< a file, relative to that of the study
  std::optional<Given> steps;  ///< a factor of all own steps and of the communication step
  std::vector<Given> set;      ///< in rows of a table that has the columns of each
  std::vector<Table> tables;
  std::vector<Reference> references;
  std::vector<Metric> metrics;
  std::optional<Formula> lost, unstable;  ///< of metrics and columns
  std::vector<Kept> kept;
  std::vector<Choice> choices;
  charts::Charts charts;

  /// Of all tables, each once; those that are searched for too.
  std::vector<std::string> columns() const;
  /// Of TABLE.csv, without status and note; and of TABLE.series.csv.
  std::vector<std::string> columns_of(const Table& table) const;
  std::vector<std::string> columns_of_series(const Table& table) const;
  const Table& table(const std::string& name) const;
  const Reference& reference(const std::string& name) const;
  const Metric& metric(const std::string& name) const;
  /// Whether a table has a metric that is a time: its rows are run after all others, one at a time.
  bool is_timed(const Table& table) const;
  /// Leaves out the other tables, and what is kept of them or chosen by them. Throws Error for a name that none has.
  void keep_tables(const std::vector<std::string>& names);
  /// Leaves out the rows for which an expression of columns is 0, and tables that lack one of its columns.
  /// Throws Error for a column that no table has, and if no row is left.
  void keep_rows(const std::string& where);
  /// What a metric tells: METRIC, and where it has these METRIC.shift, METRIC.floor and METRIC.processor.
  std::vector<std::string> names_of(const Metric& metric) const;
};

/// The language of studies.
const text::Keys& keys();

/// Reads a study, a file of its own or the table [study] in a scenario. Throws Error with file, line, the
/// value found and what is allowed.
Study read(const std::filesystem::path& file, std::uint64_t seed = 0);
/// The same of a text. file: what errors call it, and in whose folder its files lie.
Study read(const std::filesystem::path& file, const std::string& text);

}  // namespace tandem::study
