// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "recorder_file.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/error.hpp"

namespace tandem {

std::filesystem::path Recorder::path_of(std::size_t subsystem) const {
  const std::string stem =
      what_.own ? "results." + run_.topology().name(static_cast<int>(subsystem)) : "results";
  return what_.directory / (stem + (what_.format == RecordFormat::npy ? ".npy" : ".csv"));
}

/// Not opened yet.
std::unique_ptr<RecorderFile> Recorder::file_of(std::size_t subsystem) const {
  std::vector<std::string> names{"time"};
  for (const Column& column : columns_)
    if (!what_.own || static_cast<std::size_t>(column.subsystem) == subsystem) names.push_back(column.name);
  return std::make_unique<RecorderFile>(path_of(subsystem), std::move(names), what_.format);
}

/// What an earlier run wrote in the other format goes.
void Recorder::open_files() {
  std::error_code failed;
  std::filesystem::create_directories(what_.directory, failed);
  if (failed)
    throw Error(ErrorCode::input_output,
                "folder '" + what_.directory.string() + "' can't be made: " + failed.message());
  if (what_.begin) what_.begin();
  for (std::size_t i = 0; i < (what_.own ? tracks_.size() : 1); ++i) {
    files_.push_back(has_file(i) ? file_of(i) : nullptr);
    if (!files_[i]) continue;
    const auto other = what_.format == RecordFormat::npy ? ".csv" : ".npy";
    std::filesystem::remove(path_of(i).replace_extension(other), failed);
    files_[i]->create();
  }
}

void Recorder::close() {
  if (files_.empty()) return;
  if (!closed_) write_waiting(true);
  for (auto& file : files_) {
    if (!file) continue;
    file->close();
    if (!closed_ && !file->has_rows())
      notes_.push_back("file '" + file->path().string() + "' has no rows: none was to be recorded");
  }
  closed_ = true;
}

/// Writes the rows that no further sample can change; with `all`, the others too.
void Recorder::write_waiting(bool all) {
  if (what_.own)
    for (std::size_t i = 0; i < tracks_.size(); ++i) write_own(i, all);
  else
    write_at_clock(all);
}

void Recorder::write_own(std::size_t i, bool all) {
  Track& track = tracks_[i];
  const std::size_t end = known_rows(track, i, all);
  for (std::size_t row = 0; files_[i] && row < end; ++row) {
    if (!choices_[i].takes(track.time(row), row + 1 == track.size())) continue;
    files_[i]->number(track.time(row));
    for (std::size_t k = 0; k < track.outputs.size(); ++k) {
      files_[i]->number(track.value(row, k));
      if (writes_slope(track, k)) files_[i]->number(track.slope(row, k));
    }
    files_[i]->end_row();
  }
  track.drop(end);
}

/// How many rows of a file may be written: of its last one it has to be known that it is the last.
std::size_t Recorder::known_rows(const Track& track, std::size_t file, bool all) const {
  return track.size() - (!all && choices_[file].waits() ? std::min<std::size_t>(track.size(), 1) : 0);
}

void Recorder::write_at_clock(bool all) {
  Track& clock = tracks_[static_cast<std::size_t>(clock_)];
  std::size_t row = 0;
  for (const std::size_t end = known_rows(clock, 0, all);
       row < end && (place_cursors(clock.time(row)) || all); ++row) {
    clock.cursor = row;  // itself, where a jump repeats a time
    if (choices_[0].takes(clock.time(row), row + 1 == clock.size())) write_row(clock.time(row));
  }
  clock.cursor = row;
  for (Track& track : tracks_)
    track.drop(&track == &clock ? row : std::max<std::size_t>(track.cursor, 1) - 1);
}

/// False if a subsystem with recorded outputs has no sample at or after t, or a sampled one none after it.
bool Recorder::place_cursors(double t) {
  bool reached = true;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    Track& track = tracks_[i];
    if (static_cast<int>(i) == clock_ || track.outputs.empty()) continue;
    track.place_cursor(t, tolerance_);
    reached = reached && track.cursor < track.size();
  }
  return reached;
}

void Recorder::Track::place_cursor(double t, const TimeTolerance& tolerance) {
  const auto is_past = [&](double row) {
    return sampled ? !tolerance.before(t, row) : tolerance.before(row, t);
  };
  while (cursor < size() && is_past(time(cursor))) ++cursor;
}

void Recorder::write_row(double t) {
  RecorderFile& file = *files_.front();
  file.number(t);
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const Track& track = tracks_[i];
    if (track.outputs.empty()) continue;
    const bool others = static_cast<int>(i) != clock_ && track.cursor > 0;
    const bool known = track.cursor < track.size() || (others && track.sampled);
    const bool between = known && others && (track.sampled || tolerance_.before(t, track.time(track.cursor)));
    if (!known) note_end(i);
    const auto cell = [&](const auto& number) { known ? file.number(number()) : file.empty(); };
    for (std::size_t k = 0; k < track.outputs.size(); ++k) {
      cell([&] { return between ? track.between_rows(k, t) : track.value(track.cursor, k); });
      if (writes_slope(track, k))
        cell([&] { return between ? track.slope_between_rows(k, t) : track.slope(track.cursor, k); });
    }
  }
  file.end_row();
}

/// Between the row before the cursor and the cursor's.
double Recorder::Track::between_rows(std::size_t k, double t) const {
  const std::size_t a = cursor - 1, b = cursor;
  if (held[k] != 0 || jump(b)) return value(a, k);
  const double h = time(b) - time(a), s = (t - time(a)) / h, rise = value(b, k) - value(a, k);
  if (!has_slope[k]) return value(a, k) + s * rise;
  const double d = h * slope(a, k), e = h * slope(b, k);
  return value(a, k) + s * (d + s * (3.0 * rise - 2.0 * d - e + s * (d + e - 2.0 * rise)));
}

/// The derivative of between_rows() of an output with slopes.
double Recorder::Track::slope_between_rows(std::size_t k, double t) const {
  const std::size_t a = cursor - 1, b = cursor;
  if (jump(b)) return 0.0;
  const double h = time(b) - time(a), s = (t - time(a)) / h, rise = value(b, k) - value(a, k);
  const double d = h * slope(a, k), e = h * slope(b, k);
  return (d + s * (2.0 * (3.0 * rise - 2.0 * d - e) + 3.0 * s * (d + e - 2.0 * rise))) / h;
}

void Recorder::Track::drop(std::size_t count) {
  rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count * width()));
  cursor -= std::min(cursor, count);
}

void Recorder::note_end(std::size_t subsystem) {
  Track& track = tracks_[subsystem];
  if (std::exchange(track.end_noted, true)) return;
  std::string where =
      "all cells of subsystem '" + run_.topology().name(static_cast<int>(subsystem)) + "' are empty";
  if (track.size() > 0) {
    char digits[32];
    char* end = std::to_chars(digits, digits + sizeof digits, track.time(track.size() - 1)).ptr;
    where += " after t = " + std::string(digits, end) + " s, its last sample";
  }
  notes_.push_back(where);
}

}  // namespace tandem
