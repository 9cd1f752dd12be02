// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tandem {

/// A file that is read by a name that a user, or another file, gave. It has to be a regular file: what may
/// wait for ever (a FIFO, a socket, a terminal), or never end (/dev/zero), is refused without being waited
/// for. All errors are Error(input_output) and name the file.
class InputFile {
 public:
  static constexpr std::size_t longest_line = std::size_t{1} << 26;  ///< bytes

  /// what: how errors call it, "key file".
  explicit InputFile(std::filesystem::path file, std::string what = "file");
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Bytes, as it was opened; 0 of one in /proc.
  std::uint64_t size() const { return size_; }
  /// Of its mode (chmod) what others than its owner may do: 0040 is reading by its group.
  unsigned rights_of_others() const { return rights_of_others_; }

  /// Fewer bytes than there is room for only at the end.
  std::size_t read(std::span<std::byte> to);
  /// Reading goes on at this byte.
  void seek(std::uint64_t place);
  /// The next line without its end. False: there is none, or the file had none when it was opened, as it is
  /// being written. Refuses one that is too long.
  bool line(std::string& text);
  /// What is left. Refuses more than `most` bytes.
  std::string rest(std::uint64_t most);

  [[noreturn]] void refuse(const std::string& why) const;

 private:
  bool fill();

  std::filesystem::path file_;
  std::string what_;
  int number_;
  std::uint64_t size_ = 0;
  unsigned rights_of_others_ = 0;
  std::vector<char> block_;  ///< of line(): what was read ahead
  std::size_t place_ = 0, end_ = 0;
  std::uint64_t read_ = 0;  ///< bytes of the file until the block's end
};

/// All of such a file, of at most `most` bytes.
std::string read_file(const std::filesystem::path& file, std::uint64_t most,
                      const std::string& what = "file");

/// "a FIFO", "a folder", ...: what a file of this mode (stat) is.
std::string_view kind_of_file(unsigned mode);

}  // namespace tandem
