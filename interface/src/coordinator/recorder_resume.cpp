// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "recorder_file.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem {
namespace {

constexpr std::uint32_t longest_note = 1U << 20;

}  // namespace

void Recorder::flush() {
  write_waiting(false);
  for (auto& file : files_)
    if (file) file->flush();
}

void Recorder::save(ByteWriter& to) const {
  to.put(t_start_);
  for (const auto& file : files_) {
    const Beginning whole = file ? file->written() : Beginning{};
    to.put(whole.size);
    to.put(whole.sum);
  }
  for (const Track& track : tracks_) {
    to.put_list(track.rows);
    to.put(std::uint64_t{track.cursor});
    to.put(std::uint8_t{track.end_noted});
  }
  for (const RowChoice& choice : choices_) choice.write(to);
  to.put(static_cast<std::uint32_t>(notes_.size()));
  for (const std::string& note : notes_) to.put_text(note);
}

void Recorder::resume(ByteReader& from) {
  const auto t_start = from.take<double>();
  if (!std::isfinite(t_start)) from.refuse("has a recording that begins at no time");
  start(t_start);
  auto files = reopened_files(from);
  for (Track& track : tracks_) read_track(track, from);
  for (RowChoice& choice : choices_) choice.read(from);
  const std::uint64_t notes = from.take_count(sizeof(std::uint32_t));
  for (std::uint64_t k = 0; k < notes; ++k) notes_.push_back(printable(from.take_text(longest_note)));
  from.end();
  if (what_.begin) what_.begin();
  for (auto& file : files)
    if (file) file->cut_to_beginning();
  files_ = std::move(files);
}

void Recorder::read_track(Track& track, ByteReader& from) const {
  const auto rows = from.take_list();
  const auto cursor = from.take<std::uint64_t>();
  track.end_noted = from.take<std::uint8_t>() != 0;
  if (rows.size() % track.width() != 0 || cursor > rows.size() / track.width())
    from.refuse("has " + std::to_string(rows.size()) + " recorded numbers and is at row " +
                std::to_string(cursor) + " of them; allowed are rows of " + std::to_string(track.width()));
  bool sound = std::all_of(rows.begin(), rows.end(), [](double v) { return std::isfinite(v); });
  track.rows.assign(rows.begin(), rows.end());
  track.cursor = cursor;
  for (std::size_t row = 1; row < track.size(); ++row)
    sound = sound && track.time(row - 1) <= track.time(row);
  if (!sound) from.refuse("has recorded rows that are not finite, or not in the order of time");
}

/// All are looked at, and opened; none is changed.
std::vector<std::unique_ptr<RecorderFile>> Recorder::reopened_files(ByteReader& from) const {
  std::vector<std::unique_ptr<RecorderFile>> files;
  for (std::size_t i = 0; i < (what_.own ? tracks_.size() : 1); ++i) {
    const auto size = from.take<std::uint64_t>(), sum = from.take<std::uint64_t>();
    if ((size > 0) != has_file(i))
      from.refuse("has " + std::to_string(size) + " bytes of " + path_of(i).filename().string() +
                  "; allowed are " + (has_file(i) ? "1 or more" : "none"));
    files.push_back(size > 0 ? file_of(i) : nullptr);
    if (size > 0) files.back()->reopen({size, sum});
  }
  return files;
}

}  // namespace tandem
