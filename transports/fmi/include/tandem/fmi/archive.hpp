// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "tandem/fmi/packed_file.hpp"

namespace tandem::fmi {

/// A zip file that a stranger may have made. All is read from the file itself, nothing is believed.
/// Error(input_output) that names the archive and the file in it refuses:
/// - names that lead elsewhere ("..", "/x", "a\\b"), links, names that are there twice;
/// - what is encrypted;
/// - too many files, more bytes than allowed;
/// - bytes that are not the bytes that were packed.
/// It may lie in another (PackedFile).
class Archive {
 public:
  static constexpr std::uint64_t most_files = 65536;

  /// what: how errors call it. most_bytes: that may be unpacked.
  explicit Archive(std::filesystem::path file, std::string what = "FMU",
                   std::uint64_t most_bytes = std::uint64_t{1} << 30);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  bool has(const std::string& name) const { return places_.count(name) != 0; }
  /// The folders that lie directly in `folder`, "binaries/": "linux64, win64"; "none".
  std::string folders_in(std::string_view folder) const;
  /// A file as a text of at most `most` bytes.
  std::string text(const std::string& name, std::uint64_t most) const;
  /// The first part of `name` that is a file here: "a.fmu" of "a.fmu/x.xml". Empty: none is.
  std::string file_in(const std::string& name) const;
  /// Writes the files whose names begin with `folder` to the same names below `to`. All calls together write
  /// at most most_bytes.
  void unpack(std::string_view folder, const std::filesystem::path& to);
  /// One file, which is there, likewise.
  void unpack_file(const std::string& name, const std::filesystem::path& to);

  [[noreturn]] void refuse(const std::string& why) const;

 private:
  struct Place {
    std::uint64_t offset, number;  ///< in the list of files at the archive's end
    std::uint64_t size, sum;       ///< of the content, by that list
  };
  struct Close {
    void operator()(void* zip) const;
  };
  void list();
  /// Of the list, where the reader stands: a name that is allowed, and where its content is.
  std::pair<std::string, Place> entry() const;
  template <class Take>
  void read(const std::string& name, const Take& take) const;

  std::filesystem::path file_;
  std::string what_;
  std::uint64_t most_bytes_;
  PackedFile packed_;
  std::unique_ptr<void, Close> zip_;
  std::map<std::string, Place> places_;
  std::uint64_t written_ = 0;
};

}  // namespace tandem::fmi
