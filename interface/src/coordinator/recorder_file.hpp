// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "tandem/bytes.hpp"
#include "tandem/output_file.hpp"

namespace tandem {

/// The first bytes of a file, and what they are known again by.
struct Beginning {
  std::uint64_t size = 0, sum = empty_checksum;
  bool whole_row = true;  ///< it ends with the end of a row
};
/// The first `size` bytes, of which `known` have been read. Throws Error(input_output) that names the file if
/// it has fewer.
Beginning beginning_of(const std::filesystem::path& file, std::uint64_t size, Beginning known = {});

/// A CSV file that is written a row at a time through a text buffer of its own. Every error is an
/// Error(input_output) with the path; after the first one the file takes nothing more, and ends with the last
/// row that is whole.
class CsvFile {
 public:
  /// A new one; or one that is there, of which the beginning is kept: cut_to_beginning() comes first.
  explicit CsvFile(std::filesystem::path path);
  CsvFile(std::filesystem::path path, Beginning kept);
  void cut_to_beginning();

  void text(std::string_view cell);  ///< quoted where it has to be
  void number(double value);         ///< shortest text that reads back the same
  void empty();
  void end_row();

  void flush();
  /// Flushes and closes; a second call does nothing.
  void close();
  const std::filesystem::path& path() const { return path_; }
  /// After flush(): all of it. What has come since the last call is read from the file.
  Beginning written();

 private:
  void separate();
  void open(OutputFile::Begin begin);
  void end_with_row(std::size_t written);

  std::filesystem::path path_;
  std::uint64_t size_ = 0;  ///< bytes on disk
  Beginning known_;
  std::unique_ptr<OutputFile> file_;
  std::string buffer_;
  bool row_begun_ = false;
};

}  // namespace tandem
