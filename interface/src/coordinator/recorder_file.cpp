// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "recorder_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "tandem/error.hpp"

namespace tandem {
namespace {
constexpr std::size_t buffer_size = std::size_t{1} << 18;
constexpr std::size_t longest_number = 32;  // of the shortest form of a double; 24 are needed
}  // namespace

Beginning beginning_of(const std::filesystem::path& file, std::uint64_t size, Beginning known) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorCode::input_output, "file '" + file.string() + "' can't be gone on with: " + why);
  };
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(std::generic_category().message(errno));
  in.seekg(static_cast<std::streamoff>(known.size));
  for (std::vector<char> block(buffer_size); known.size < size; known.size += block.size()) {
    block.resize(std::min<std::uint64_t>(block.size(), size - known.size));
    if (!in.read(block.data(), static_cast<std::streamsize>(block.size())))
      refuse("it is shorter than " + std::to_string(size) + " bytes, as it was at the checkpoint");
    known.sum = checksum(std::as_bytes(std::span(block)), known.sum);
  }
  return known;
}

CsvFile::CsvFile(std::filesystem::path path) : path_(std::move(path)) { open("wb"); }

CsvFile::CsvFile(std::filesystem::path path, Beginning kept)
    : path_(std::move(path)), size_(kept.size), known_(kept) {
  std::error_code failed;
  std::filesystem::resize_file(path_, size_, failed);
  errno = failed.value();
  if (failed) fail();
  open("ab");
}

void CsvFile::open(const char* mode) {
  file_.reset(std::fopen(path_.c_str(), mode));
  if (!file_) fail();
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  buffer_.reserve(buffer_size + buffer_size / 4);
}

void CsvFile::fail() {
  const std::string why = std::generic_category().message(errno);
  file_.reset();
  buffer_.clear();
  throw Error(ErrorCode::input_output, "file '" + path_.string() + "' can't be written: " + why);
}

void CsvFile::separate() {
  if (std::exchange(row_begun_, true)) buffer_ += ',';
}

void CsvFile::text(std::string_view cell) {
  separate();
  if (cell.find_first_of(",\"\r\n") == std::string_view::npos) {
    buffer_ += cell;
    return;
  }
  buffer_ += '"';
  for (const char c : cell) buffer_.append(c == '"' ? 2 : 1, c);
  buffer_ += '"';
}

void CsvFile::number(double value) {
  separate();
  char digits[longest_number];
  buffer_.append(digits, std::to_chars(digits, digits + longest_number, value).ptr);
}

void CsvFile::empty() { separate(); }

void CsvFile::end_row() {
  buffer_ += '\n';
  row_begun_ = false;
  if (buffer_.size() >= buffer_size) flush();
}

/// Of a write that fails in the middle, on a full disk, the rows that are whole are kept.
void CsvFile::flush() {
  if (!file_) return buffer_.clear();
  const std::size_t written = std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get());
  if (written < buffer_.size()) {
    const int why = errno;
    std::error_code is_no_file;
    std::filesystem::resize_file(path_, size_ + buffer_.substr(0, written).rfind('\n') + 1, is_no_file);
    errno = why;
    fail();
  }
  size_ += written;
  buffer_.clear();
}

Beginning CsvFile::written() { return known_ = beginning_of(path_, size_, known_); }

void CsvFile::close() {
  flush();
  if (file_ && std::fclose(file_.release()) != 0) fail();
}

}  // namespace tandem
