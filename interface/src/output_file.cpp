// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem {
namespace {

std::string not_written(const std::filesystem::path& file, const std::string& why) {
  return "file '" + file.string() + "' can't be written: " + why;
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
  throw Error(ErrorCode::input_output, not_written(file, why));
}

int flags_of(OutputFile::Begin begin) {
  const int always = O_WRONLY | O_CREAT | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  if (begin == OutputFile::Begin::fresh) return always | O_EXCL;
  return begin == OutputFile::Begin::kept ? always | O_APPEND : always;
}

}  // namespace

/// O_NONBLOCK: only until it is known what the file is.
OutputFile::OutputFile(std::filesystem::path file, Begin begin)
    : path_(std::move(file)), number_(::open(path_.c_str(), flags_of(begin), 0666)) {
  if (number_ < 0 && errno == ENXIO) fail(path_, "it is a FIFO or a socket; allowed is a regular file");
  require(number_ >= 0);
  try {
    check_kind();
    ::fcntl(number_, F_SETFL, begin == Begin::kept ? O_APPEND : 0);
    if (begin == Begin::empty) cut(0);
  } catch (const Error&) {
    ::close(number_);
    throw;
  }
}

void OutputFile::check_kind() {
  struct stat status {};
  require(::fstat(number_, &status) == 0);
  regular_ = S_ISREG(status.st_mode);
  if (!regular_ && !S_ISCHR(status.st_mode))
    fail(path_, "it is " + std::string(kind_of_file(status.st_mode)) + "; allowed is a regular file");
}

OutputFile::~OutputFile() {
  if (number_ >= 0) ::close(number_);
}

void OutputFile::require(bool done) const {
  if (done) return;
  const int number = errno;
  const std::string why = number == EISDIR ? "it is a folder" : std::generic_category().message(number);
  if (number == ENOSPC || number == EDQUOT || number == EFBIG) throw NoRoom(not_written(path_, why));
  fail(path_, why);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::write(number_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    require(count > 0);
    written_ += static_cast<std::uint64_t>(count);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// A file that is written at its end takes nothing at another place.
void OutputFile::write_at(std::uint64_t place, std::string_view bytes) {
  ::fcntl(number_, F_SETFL, 0);
  while (!bytes.empty()) {
    const auto count = ::pwrite(number_, bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (count < 0 && errno == EINTR) continue;
    require(count > 0);
    place += static_cast<std::uint64_t>(count);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  require(!regular_ || ::lseek(number_, 0, SEEK_END) >= 0);
}

void OutputFile::cut(std::uint64_t size) {
  if (regular_) require(::ftruncate(number_, static_cast<off_t>(size)) == 0);
}

void OutputFile::sync() { require(!regular_ || ::fsync(number_) == 0); }

void OutputFile::close() {
  if (const int number = std::exchange(number_, -1); number >= 0) require(::close(number) == 0);
}

}  // namespace tandem
