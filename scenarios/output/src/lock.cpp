// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/output/files.hpp"

namespace tandem::output {
namespace {

namespace fs = std::filesystem;

/// " (process 4711)": who holds the lock, from a line of Linux' /proc/locks (proc(5)),
/// "2: FLOCK ADVISORY WRITE 4711 08:01:1234 0 EOF"; empty where that is not told.
std::string holder_of(const struct stat& file) {
  std::ifstream locks("/proc/locks");
  std::ostringstream wanted;
  wanted << std::hex << (major(file.st_dev) < 16 ? "0" : "") << major(file.st_dev) << ':'
         << (minor(file.st_dev) < 16 ? "0" : "") << minor(file.st_dev) << ':' << std::dec << file.st_ino;
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, advisory, access, process, place;
    words >> number >> kind >> advisory >> access >> process >> place;
    if (kind == "FLOCK" && place == wanted.str() && process.find_first_not_of("0123456789") == process.npos &&
        process != "0")
      return " (process " + process + ")";
  }
  return "";
}

enum class Lock { taken, busy, unknown };

Lock lock(int descriptor) {
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return Lock::busy;
    if (errno != EINTR) return Lock::unknown;
  }
  return Lock::taken;
}

[[noreturn]] void refuse_busy(int descriptor, const std::string& what) {
  struct stat status {};
  ::fstat(descriptor, &status);
  throw Error(ErrorCode::wrong_state, what + " is being written by another tandem" + holder_of(status) +
                                          "; allowed is one at a time: wait for its end, or name another");
}

}  // namespace

FolderLock::FolderLock(fs::path folder, const Note& note) : folder_(std::move(folder)) {
  try {
    do {
      if (number_ >= 0) ::close(number_);
      make();
      number_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    } while (!take(note));
  } catch (...) {
    if (number_ >= 0) ::close(number_);
    throw;
  }
}

FolderLock::~FolderLock() {
  remove_made();
  if (number_ >= 0) ::close(number_);
}

void FolderLock::make() {
  made_.clear();
  std::error_code failed;
  for (fs::path one = fs::absolute(folder_).lexically_normal();
       !fs::exists(one, failed) && one.has_relative_path(); one = one.parent_path())
    if (one.has_filename()) made_.insert(made_.begin(), one);
  make_folder(folder_);
}

/// False: another that ended meanwhile has taken the folder with it.
bool FolderLock::take(const Note& note) {
  const Lock got = number_ >= 0 ? lock(number_) : Lock::unknown;
  if (got == Lock::busy) refuse_busy(number_, "folder '" + folder_.string() + "'");
  if (got == Lock::unknown) {
    note("folder '" + folder_.string() + "' can't be locked (" + std::generic_category().message(errno) +
         "): let no other run write to it");
    return true;
  }
  return keeps(folder_);
}

bool FolderLock::keeps(const fs::path& folder) const {
  struct stat here {
  }, there{};
  return number_ >= 0 && ::fstat(number_, &here) == 0 && ::stat(folder.c_str(), &there) == 0 &&
         here.st_dev == there.st_dev && here.st_ino == there.st_ino;
}

/// Of those that are empty.
void FolderLock::remove_made() noexcept {
  while (!made_.empty() && ::rmdir(made_.back().c_str()) == 0) made_.pop_back();
}

void lock_file(int descriptor, const std::string& what) {
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && lock(descriptor) == Lock::busy)
    refuse_busy(descriptor, what);
}

}  // namespace tandem::output
