// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/files_read.hpp"

namespace tandem {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 16;

std::string reason() { return std::generic_category().message(errno); }

}  // namespace

std::string_view kind_of_file(unsigned mode) {
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISSOCK(mode)) return "a socket";
  return S_ISREG(mode) ? "a regular file" : "a device";
}

/// O_NONBLOCK: a FIFO is opened without waiting for who writes it, only to be told from a file.
InputFile::InputFile(std::filesystem::path file, std::string what)
    : file_(std::move(file)),
      what_(std::move(what)),
      number_(::open(file_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
  if (number_ < 0 && (errno == ENOENT || errno == ENOTDIR))
    throw Error(ErrorCode::input_output, what_ + " '" + file_.string() + "' is not there");
  if (number_ < 0) refuse(reason());
  struct stat status {};
  if (::fstat(number_, &status) == 0 && S_ISREG(status.st_mode)) {
    size_ = static_cast<std::uint64_t>(status.st_size);
    rights_of_others_ = status.st_mode & (S_IRWXG | S_IRWXO);
    FilesRead::note(file_);
    return;
  }
  ::close(number_);
  refuse("it is " + std::string(kind_of_file(status.st_mode)) + "; allowed is a regular file");
}

InputFile::~InputFile() { ::close(number_); }

std::size_t InputFile::read(std::span<std::byte> to) {
  std::size_t count = 0;
  while (count < to.size()) {
    const auto more = ::read(number_, to.data() + count, to.size() - count);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) refuse(reason());
    if (more == 0) break;
    count += static_cast<std::size_t>(more);
  }
  return count;
}

void InputFile::seek(std::uint64_t place) {
  place_ = end_ = 0;
  read_ = place;
  if (::lseek(number_, static_cast<off_t>(place), SEEK_SET) < 0) refuse(reason());
}

bool InputFile::fill() {
  block_.resize(block_size);
  place_ = 0;
  end_ = read(std::as_writable_bytes(std::span(block_)));
  read_ += end_;
  return end_ > 0;
}

bool InputFile::line(std::string& text) {
  text.clear();
  if (size_ > 0 && read_ - (end_ - place_) >= size_) return false;
  if (place_ == end_ && !fill()) return false;
  do {
    const char* const from = block_.data() + place_;
    const auto* stop = static_cast<const char*>(std::memchr(from, '\n', end_ - place_));
    text.append(from, stop ? stop : block_.data() + end_);
    place_ = stop ? static_cast<std::size_t>(stop - block_.data()) + 1 : end_;
    if (stop) return true;
    if (text.size() > longest_line)
      refuse("it has a line of more than " + std::to_string(longest_line) + " bytes, the most allowed");
  } while (fill());
  return true;
}

std::string InputFile::rest(std::uint64_t most) {
  std::string text;
  do {
    if (text.size() > most || size_ > most)
      refuse("it has " + std::to_string(std::max<std::uint64_t>(size_, text.size())) +
             " bytes; allowed are up to " + std::to_string(most));
    text.append(block_.data() + place_, end_ - place_);
  } while (fill());
  place_ = end_ = 0;
  return text;
}

void InputFile::refuse(const std::string& why) const {
  throw Error(ErrorCode::input_output, what_ + " '" + file_.string() + "' can't be read: " + why);
}

std::string read_file(const std::filesystem::path& file, std::uint64_t most, const std::string& what) {
  return InputFile(file, what).rest(most);
}

}  // namespace tandem
