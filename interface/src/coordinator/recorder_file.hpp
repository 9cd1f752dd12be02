// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace tandem {

/// A CSV file that is written a row at a time through a text buffer of its own. Every error is an
/// Error(input_output) with the path; after the first one the file takes nothing more.
class CsvFile {
 public:
  explicit CsvFile(std::filesystem::path path);

  void text(std::string_view cell);  ///< quoted where it has to be
  void number(double value);         ///< shortest text that reads back the same
  void empty();
  void end_row();

  void flush();
  /// Flushes and closes; a second call does nothing.
  void close();
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void separate();
  [[noreturn]] void fail();

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string buffer_;
  bool row_begun_ = false;
};

}  // namespace tandem
