// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "recorder_file.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/npy.hpp"

namespace tandem {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;
constexpr std::size_t longest_number = 32;  // of the shortest form of a double; 24 are needed

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string to = "\"";
  for (const char c : cell) to.append(c == '"' ? 2 : 1, c);
  return to + "\"";
}

std::string csv_head(const std::vector<std::string>& names) {
  std::string row;
  for (const std::string& name : names) row += (row.empty() ? "" : ",") + quoted(name);
  return row + "\n";
}

/// Goes on with what is known of a file until it has `size` bytes.
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
  }
  return known;
}

std::string first_bytes(const std::filesystem::path& file, std::uint64_t count, std::uint64_t from = 0) {
  InputFile in(file);
  in.seek(from);
  std::string bytes(count, '\0');
  bytes.resize(in.read(std::as_writable_bytes(std::span(bytes))));
  return bytes;
}

}  // namespace

RecorderFile::RecorderFile(std::filesystem::path path, std::vector<std::string> names, RecordFormat format)
    : path_(std::move(path)), names_(std::move(names)), format_(format) {
  head_size_ = head().size();
  known_.size = head_size_;
}

std::string RecorderFile::head() const {
  return binary() ? npy_head(names_, size_ > head_size_ ? (size_ - head_size_) / row_size() : 0)
                  : csv_head(names_);
}

void RecorderFile::open(OutputFile::Begin begin) {
  file_ = std::make_unique<OutputFile>(path_, begin);
  buffer_.reserve(buffer_size + buffer_size / 4);
}

void RecorderFile::create() {
  open(OutputFile::Begin::empty);
  buffer_ += head();
}

void RecorderFile::reopen(const Beginning& kept) {
  check(kept);
  size_ = kept.size;
  open(OutputFile::Begin::kept);
}

void RecorderFile::check(const Beginning& kept) {
  bool same = kept.size >= head_size_;
  if (same) known_ = beginning_of(path_, kept.size, known_);
  const std::string own = same ? first_bytes(path_, head_size_) : "";
  if (same && binary())
    same = (kept.size - head_size_) % row_size() == 0 &&
           read_npy_head(std::as_bytes(std::span(own))).names == names_;
  else if (same)
    same = own == head() && first_bytes(path_, 1, kept.size - 1) == "\n";
  same = same && known_.sum == kept.sum;
  if (!same)
    throw Error(ErrorCode::input_output, "file '" + path_.string() + "' can't be gone on with: its first " +
                                             std::to_string(kept.size) +
                                             " bytes are others than those of the run at the checkpoint");
}

void RecorderFile::cut_to_beginning() {
  file_->cut(size_);
  tell_rows();
}

void RecorderFile::separate() {
  if (std::exchange(row_begun_, true)) buffer_ += ',';
}

void RecorderFile::number(double value) {
  char digits[longest_number];
  if (binary()) {
    for (const std::byte b : to_wire(value)) buffer_ += static_cast<char>(b);
  } else {
    separate();
    buffer_.append(digits, std::to_chars(digits, digits + longest_number, value).ptr);
  }
}

void RecorderFile::empty() { binary() ? number(std::numeric_limits<double>::quiet_NaN()) : separate(); }

void RecorderFile::end_row() {
  if (!binary()) buffer_ += '\n';
  row_begun_ = false;
  if (buffer_.size() >= buffer_size) flush();
}

/// Of a write that fails in the middle, on a full disk, the rows that are whole are kept.
void RecorderFile::flush() {
  if (!file_) return buffer_.clear();
  const std::uint64_t before = file_->written();
  try {
    file_->write(buffer_);
  } catch (const Error&) {
    end_with_row(file_->written() - before);
    throw;
  }
  size_ += buffer_.size();
  if (!buffer_.empty()) tell_rows();
  buffer_.clear();
}

void RecorderFile::tell_rows() {
  if (binary()) file_->write_at(0, head());
}

/// So many bytes of the buffer are in the file. The error of the write is the one to be heard of.
void RecorderFile::end_with_row(std::uint64_t written) try {
  const std::string rows = std::exchange(buffer_, {});
  const std::uint64_t end = size_ + written;
  if (!binary())
    size_ += rows.substr(0, static_cast<std::size_t>(written)).rfind('\n') + 1;
  else if (end > head_size_)
    size_ = end - (end - head_size_) % row_size();
  file_->cut(size_);
  if (size_ > 0) tell_rows();
  file_.reset();
} catch (const Error&) {
  file_.reset();
}

Beginning RecorderFile::written() { return known_ = beginning_of(path_, size_, known_); }

void RecorderFile::close() {
  flush();
  if (const auto file = std::exchange(file_, nullptr)) file->close();
}

}  // namespace tandem
