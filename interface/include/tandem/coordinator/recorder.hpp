// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"
#include "tandem/coordinator/row_choice.hpp"

namespace tandem {

class RecorderFile;

/// Of files of results: text, or numpy's (tandem/npy.hpp).
enum class RecordFormat { csv, npy };

/// What a run writes, and where.
struct Recording {
  std::filesystem::path directory = ".";  ///< Made if it is not there; earlier results in it are replaced.
  std::string clock = {};  ///< The instance at whose own steps rows stand; empty: the smallest first step.
  bool own = false;        ///< A file for each subsystem instead, at its own steps.
  std::vector<std::string> ports = {};  ///< Outputs, "instance.port" or "instance.port[i]"; empty: all.
  RowRules rows = {};                   ///< Which there are.
  std::function<void()> begin = {};     ///< Called once, before files of an earlier run are replaced or cut.
  RecordFormat format = RecordFormat::csv;
  bool derivatives = false;  ///< "der(instance.port)" beside each output that gives derivatives.
};

/// Of the first of `ports` that names none of `outputs`, nor an array of them: "recorded output 'x' is not
/// there; ..."; else empty.
std::string unknown_output(const std::vector<std::string>& outputs, const std::vector<std::string>& ports);

/// Writes the outputs of a run: `results.csv`, or with `own` one `results.INSTANCE.csv` each; or `.npy`. One
/// header row, `time` first, then `instance.port` (`instance.port[i]` for arrays) in the order of the
/// topology; numbers as text in the fewest digits that read back the same. Times may repeat where the clock's
/// instance jumps.
///
/// At the clock's times the outputs of the other subsystems are interpolated: cubic Hermite where the port
/// gives derivatives, else linear. At a jump they have the value before it. Nothing is interpolated across a
/// jump: the value before is held. A cell is empty where its subsystem has no sample at or after that time. A
/// derivative is the derivative of the curve that its output was interpolated by.
///
/// samples() only copies into memory that is reserved at the first call (it grows if nobody calls
/// between_rounds()); the files are written by between_rounds(), when that memory is half full, and by
/// close(). After an error of a write nothing more is written to that file.
class Recorder final : public Observer {
 public:
  enum class Fill { own, hermite, linear, held };
  static std::string_view name(Fill fill);
  struct Column {
    int subsystem;
    std::string name, unit;
    Fill fill;  ///< how its cells were made: own samples, interpolated, or constant from one to the next
  };

  /// `run` must outlive the recorder. Throws Error for a clock or port that is not there.
  Recorder(const Coordinator& run, Recording what);
  ~Recorder() override;  ///< closes what is open; errors pass unseen
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// At the first call (the end of Coordinator::initialize) folder and files are opened, so that a run that
  /// can't begin leaves earlier results as they are. Throws Error(input_output) with the path.
  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override;
  /// Throws Error(input_output) with the path.
  void between_rounds() override;
  /// Writes all rows that are complete: they are in the files if the process is killed. Throws as above.
  void flush();

  /// After flush(): what the files hold, as a checksum, and the samples that still wait; for a checkpoint.
  void save(ByteWriter& to) const;
  /// In place of the first samples: cuts the files of the other run where it was saved, and goes on. What was
  /// saved is the last in `from`, and all of it is checked before the first file is cut. Throws
  /// Error(input_output) for a file that is not there, is shorter, or holds anything else.
  void resume(ByteReader& from);

  /// Writes what is left and closes the files. Also after a failed run: all that it was told of gets written.
  /// Throws Error(input_output) with the path.
  void close();

  /// By column of the files, `time` left out. `fill` is known after the first samples.
  const std::vector<Column>& columns() const { return columns_; }
  std::vector<std::filesystem::path> files() const;
  /// Cells left empty. Complete after close().
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// The recorded samples of one subsystem that still wait: rows of time, jump flag, values, first
  /// derivatives.
  struct Track {
    std::vector<int> outputs;     ///< flattened indices of what is recorded
    std::vector<char> has_slope;  ///< by recorded output
    std::vector<char> held;       ///< likewise
    bool sampled = false;         ///< all of them hold on after the last row
    std::vector<double> rows;
    /// First row at or after the time that is being written; of a sampled one, after.
    std::size_t cursor = 0;
    bool end_noted = false;

    std::size_t width() const { return 2 + 2 * outputs.size(); }
    std::size_t size() const { return rows.size() / width(); }
    double time(std::size_t row) const { return rows[row * width()]; }
    bool jump(std::size_t row) const { return rows[row * width() + 1] != 0.0; }
    double value(std::size_t row, std::size_t k) const { return rows[row * width() + 2 + k]; }
    double slope(std::size_t row, std::size_t k) const {
      return rows[row * width() + 2 + outputs.size() + k];
    }
    void place_cursor(double t, const TimeTolerance& tolerance);
    double between_rows(std::size_t k, double t) const;
    double slope_between_rows(std::size_t k, double t) const;
    void drop(std::size_t count);
  };

  void choose_columns();
  void start(double t_start);
  int smallest_step() const;
  std::filesystem::path path_of(std::size_t subsystem) const;
  bool has_file(std::size_t subsystem) const { return !what_.own || !tracks_[subsystem].outputs.empty(); }
  void open_files();
  std::unique_ptr<RecorderFile> file_of(std::size_t subsystem) const;
  std::vector<std::unique_ptr<RecorderFile>> reopened_files(ByteReader& from) const;
  void read_track(Track& track, ByteReader& from) const;
  void write_waiting(bool all);
  void write_own(std::size_t subsystem, bool all);
  void write_at_clock(bool all);
  std::size_t known_rows(const Track& track, std::size_t file, bool all) const;
  bool place_cursors(double t);
  void write_row(double t);
  bool writes_slope(const Track& track, std::size_t k) const {
    return what_.derivatives && track.has_slope[k] != 0;
  }
  void note_end(std::size_t subsystem);

  const Coordinator& run_;
  Recording what_;
  int clock_ = -1;
  double t_start_ = 0.0;
  TimeTolerance tolerance_;
  std::vector<Track> tracks_;  ///< by subsystem
  std::vector<Column> columns_;
  std::vector<std::unique_ptr<RecorderFile>> files_;  ///< one, or by subsystem
  std::vector<RowChoice> choices_;                    ///< likewise
  std::vector<std::string> notes_;
  bool closed_ = false;
};

}  // namespace tandem
