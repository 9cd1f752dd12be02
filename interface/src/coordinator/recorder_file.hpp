// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tandem/bytes.hpp"
#include "tandem/coordinator/recorder.hpp"
#include "tandem/output_file.hpp"

namespace tandem {

/// What a file is known again by: its size in bytes, and a checksum of its rows.
struct Beginning {
  std::uint64_t size = 0, sum = empty_checksum;
};

/// A table in a file that is written a row at a time through a buffer of its own. Every error is an
/// Error(input_output) with the path; after the first one the file takes nothing more, and ends with the last
/// row that is whole.
class RecorderFile {
 public:
  /// names: of the columns, `time` the first.
  RecorderFile(std::filesystem::path path, std::vector<std::string> names, RecordFormat format);

  /// Begins anew. Once, before anything else; or this:
  void create();
  /// Goes on with a file that is there, of which the beginning is kept. Throws Error if it is another one;
  /// nothing of it is changed until it is cut.
  void reopen(const Beginning& kept);
  void cut_to_beginning();

  void number(double value);  ///< as text: the shortest that reads back the same
  void empty();
  void end_row();

  void flush();
  /// Flushes and closes; a second call does nothing.
  void close();
  const std::filesystem::path& path() const { return path_; }
  bool has_rows() const { return size_ > head_size_; }  ///< after flush()
  /// After flush(): all of it. What has come since the last call is read from the file.
  Beginning written();

 private:
  bool binary() const { return format_ == RecordFormat::npy; }
  std::string head() const;
  std::uint64_t row_size() const { return 8 * names_.size(); }  ///< bytes, where it is binary
  void separate();
  void open(OutputFile::Begin begin);
  void tell_rows();
  void end_with_row(std::uint64_t written);
  void check(const Beginning& kept);

  std::filesystem::path path_;
  std::vector<std::string> names_;
  RecordFormat format_;
  std::uint64_t head_size_ = 0, size_ = 0;  ///< bytes; of all that is on the disk
  Beginning known_;
  std::unique_ptr<OutputFile> file_;
  std::string buffer_;
  bool row_begun_ = false;
};

}  // namespace tandem
