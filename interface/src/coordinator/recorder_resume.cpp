// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "recorder_file.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

constexpr std::uint64_t longest_tail = std::uint64_t{1} << 16;  // bytes by which a file is known again
constexpr std::uint32_t longest_note = 1U << 20;

[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorCode::input_output, "file '" + path.string() + "' can't be gone on with: " + why);
}

/// Checksum of the bytes before `end`.
std::uint64_t tail_of(const std::filesystem::path& path, std::uint64_t end) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse_file(path, std::generic_category().message(errno));
  std::vector<char> tail(std::min(end, longest_tail));
  in.seekg(static_cast<std::streamoff>(end - tail.size()));
  in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  if (!in)
    refuse_file(path, "it is shorter than " + std::to_string(end) + " bytes, as it was at the checkpoint");
  return checksum(std::as_bytes(std::span(tail)));
}

}  // namespace

void Recorder::flush() {
  write_waiting(false);
  for (auto& file : files_)
    if (file) file->flush();
}

void Recorder::save(ByteWriter& to) const {
  to.put(t_start_);
  for (const auto& file : files_) {
    to.put(file ? file->size() : std::uint64_t{0});
    to.put(file ? tail_of(file->path(), file->size()) : std::uint64_t{0});
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
  std::vector<std::uint64_t> ends(what_.own ? tracks_.size() : 1);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ends[i] = from.take<std::uint64_t>();
    const auto tail = from.take<std::uint64_t>();
    if (ends[i] > 0 && tail_of(path_of(i), ends[i]) != tail)
      refuse_file(path_of(i), "it is of another run than the checkpoint: up to byte " +
                                  std::to_string(ends[i]) + " it holds something else");
  }
  for (std::size_t i = 0; i < ends.size(); ++i)
    files_.push_back(ends[i] > 0 ? std::make_unique<CsvFile>(path_of(i), ends[i]) : nullptr);
}

}  // namespace tandem
