// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace tandem {

/// A CSV file that is written a row at a time through a text buffer of its own. Every error is an
/// Error(input_output) with the path; after the first one the file takes nothing more, and ends with the last
/// row that is whole.
class CsvFile {
 public:
  /// A new one, or one that is there, from its byte `end` on.
  explicit CsvFile(std::filesystem::path path);
  CsvFile(std::filesystem::path path, std::uint64_t end);

  void text(std::string_view cell);  ///< quoted where it has to be
  void number(double value);         ///< shortest text that reads back the same
  void empty();
  void end_row();

  void flush();
  /// Flushes and closes; a second call does nothing.
  void close();
  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }  ///< bytes, all written after flush()

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void separate();
  void open(const char* mode);
  [[noreturn]] void fail();

  std::filesystem::path path_;
  std::uint64_t size_ = 0;
  std::unique_ptr<std::FILE, Close> file_;
  std::string buffer_;
  bool row_begun_ = false;
};

}  // namespace tandem
