// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tandem {

/// A file that is written. What is there already has to be a regular file or a device (/dev/null, a
/// terminal): a FIFO, which may wait for ever for who reads it, is refused. All errors are
/// Error(input_output): "file 'NAME' can't be written: why".
class OutputFile {
 public:
  enum class Begin {
    empty,  ///< in place of what is there
    kept,   ///< at the end of what is there
    fresh,  ///< of a name that nothing has; links are not followed
  };
  OutputFile(std::filesystem::path file, Begin begin);
  ~OutputFile();  ///< closes it; an error passes unseen
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  std::uint64_t written() const { return written_; }  ///< bytes by write(), of one that failed too
  /// In place of what stands at that byte.
  void write_at(std::uint64_t place, std::string_view bytes);
  /// Keeps the first bytes only; of a device nothing.
  void cut(std::uint64_t size);
  /// Puts it on the disk.
  void sync();
  void close();

  const std::filesystem::path& path() const { return path_; }
  int descriptor() const { return number_; }

 private:
  void check_kind();
  void require(bool done) const;

  std::filesystem::path path_;
  int number_;
  std::uint64_t written_ = 0;
  bool regular_ = false;
};

}  // namespace tandem
