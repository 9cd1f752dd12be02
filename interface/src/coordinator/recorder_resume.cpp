// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "recorder_file.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/error.hpp"

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
  to.put(static_cast<std::uint32_t>(notes_.size()));
  for (const std::string& note : notes_) to.put_text(note);
}

void Recorder::resume(ByteReader& from) {
  start(from.take<double>());
  reopen_files(from);
  for (Track& track : tracks_) {
    const auto rows = from.take_list();
    track.cursor = from.take<std::uint64_t>();
    track.end_noted = from.take<std::uint8_t>() != 0;
    if (rows.size() % track.width() != 0 || track.cursor > rows.size() / track.width())
      from.refuse("has " + std::to_string(rows.size()) + " recorded numbers; allowed are rows of " +
                  std::to_string(track.width()));
    track.rows.assign(rows.begin(), rows.end());
  }
  const std::uint64_t notes = from.take_count(sizeof(std::uint32_t));
  for (std::uint64_t k = 0; k < notes; ++k) notes_.push_back(from.take_text(longest_note));
}

/// All are looked at before the first is cut.
void Recorder::reopen_files(ByteReader& from) {
  std::vector<Beginning> kept(what_.own ? tracks_.size() : 1);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i] = {from.take<std::uint64_t>(), from.take<std::uint64_t>()};
    if (kept[i].size > 0 && beginning_of(path_of(i), kept[i].size).sum != kept[i].sum)
      throw Error(ErrorCode::input_output, "file '" + path_of(i).string() +
                                               "' can't be gone on with: its first " +
                                               std::to_string(kept[i].size) +
                                               " bytes are others than those of the run at the checkpoint");
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
    files_.push_back(kept[i].size > 0 ? std::make_unique<CsvFile>(path_of(i), kept[i]) : nullptr);
}

}  // namespace tandem
