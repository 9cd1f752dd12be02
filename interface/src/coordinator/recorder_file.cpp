// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "recorder_file.hpp"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem {
namespace {
constexpr std::size_t buffer_size = std::size_t{1} << 18;
constexpr std::size_t longest_number = 32;  // of the shortest form of a double; 24 are needed
}  // namespace

Beginning beginning_of(const std::filesystem::path& file, std::uint64_t size, Beginning known) {
  InputFile in(file);
  in.seek(known.size);
  for (std::vector<std::byte> block(buffer_size); known.size < size; known.size += block.size()) {
    block.resize(std::min<std::uint64_t>(block.size(), size - known.size));
    if (in.read(block) < block.size())
      throw Error(ErrorCode::input_output, "file '" + file.string() +
                                               "' can't be gone on with: it is shorter than " +
                                               std::to_string(size) + " bytes, as it was at the checkpoint");
    known.sum = checksum(block, known.sum);
    known.whole_row = block.back() == std::byte{'\n'};
  }
  return known;
}

CsvFile::CsvFile(std::filesystem::path path) : path_(std::move(path)) { open(OutputFile::Begin::empty); }

CsvFile::CsvFile(std::filesystem::path path, Beginning kept)
    : path_(std::move(path)), size_(kept.size), known_(kept) {
  open(OutputFile::Begin::kept);
}

void CsvFile::open(OutputFile::Begin begin) {
  file_ = std::make_unique<OutputFile>(path_, begin);
  buffer_.reserve(buffer_size + buffer_size / 4);
}

void CsvFile::cut_to_beginning() { file_->cut(size_); }

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
  const std::uint64_t before = file_->written();
  try {
    file_->write(buffer_);
  } catch (const Error&) {
    end_with_row(static_cast<std::size_t>(file_->written() - before));
    throw;
  }
  size_ += buffer_.size();
  buffer_.clear();
}

/// So many bytes of the buffer are in the file. The error of the write is the one to be heard of.
void CsvFile::end_with_row(std::size_t written) try {
  const auto file = std::exchange(file_, nullptr);
  const std::string rows = std::exchange(buffer_, {});
  file->cut(size_ + rows.substr(0, written).rfind('\n') + 1);
} catch (const Error&) {
}

Beginning CsvFile::written() { return known_ = beginning_of(path_, size_, known_); }

void CsvFile::close() {
  flush();
  if (const auto file = std::exchange(file_, nullptr)) file->close();
}

}  // namespace tandem
