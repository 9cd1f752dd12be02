// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/temporary_folder.hpp"

#include <fcntl.h>
#include <stdlib.h>  // mkdtemp
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>

#include "tandem/error.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;

const std::string prefix = "tandem_temporary_";

/// -1 if it can't be opened.
int open_folder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// It is this user's, old enough that whoever made it has its lock, and nobody has.
bool is_left_over(int folder) {
  struct stat about {};
  constexpr auto young = std::chrono::minutes(1);
  const auto before = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now() - young);
  return ::fstat(folder, &about) == 0 && about.st_uid == ::geteuid() && about.st_mtime < before &&
         ::flock(folder, LOCK_EX | LOCK_NB) == 0;
}

void remove_left_over(const fs::path& among) {
  std::error_code ignored;
  for (const fs::directory_entry& one : fs::directory_iterator(among, ignored)) {
    if (!one.path().filename().string().starts_with(prefix)) continue;
    const int folder = open_folder(one.path());
    if (folder < 0) continue;
    if (is_left_over(folder)) fs::remove_all(one.path(), ignored);
    ::close(folder);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code none;
  const fs::path among = fs::temp_directory_path(none);
  if (none)
    throw Error(ErrorCode::input_output, "there is no folder for temporary files: " + none.message() +
                                             "; TMPDIR names it, else it is /tmp");
  remove_left_over(among);
  std::string name = (fs::absolute(among) / (prefix + "XXXXXX")).string();  // a program may work elsewhere
  if (!::mkdtemp(name.data()))
    throw Error(ErrorCode::input_output, "no folder can be made in " + among.string() + ": " +
                                             std::error_code(errno, std::generic_category()).message());
  path_ = name;
  lock_ = open_folder(path_);
  ::flock(lock_, LOCK_EX);  // the system gives it back when this process ends
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace tandem
