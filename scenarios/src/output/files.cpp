// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "tandem/error.hpp"

namespace tandem::output {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw Error(ErrorCode::input_output,
              what + " '" + path.string() + "' can't be " + (what == "file" ? "written: " : "made: ") + why);
}

}  // namespace

void write_text(const fs::path& file, const std::string& text) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (out) return;
  const std::string why = std::generic_category().message(errno);
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);  // half a text is of no use
  fail("file", file, why);
}

void replace_text(const fs::path& file, const std::string& text) {
  fs::path part = file;
  part += ".part";
  write_text(part, text);
  std::error_code failed;
  fs::rename(part, file, failed);
  if (failed) fail("file", file, failed.message());
}

namespace {

/// An open file, which closes with it.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : path_(path), number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    check(number_ >= 0);
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const auto written = ::write(number_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      check(written > 0);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }
  void sync() { check(::fsync(number_) == 0); }

 private:
  void check(bool done) const {
    if (!done) fail("file", path_, std::generic_category().message(errno));
  }
  const fs::path& path_;
  int number_;
};

}  // namespace

void replace_durably(const fs::path& file, std::span<const std::byte> bytes) {
  fs::path part = file;
  part += ".part";
  std::error_code failed;
  try {
    Descriptor out(part, O_WRONLY | O_CREAT | O_TRUNC);
    out.write(bytes);
    out.sync();
  } catch (...) {
    fs::remove(part, failed);
    throw;
  }
  fs::rename(part, file, failed);
  if (failed) fail("file", file, failed.message());
  const fs::path folder = fs::absolute(file).parent_path();
  Descriptor(folder, O_RDONLY | O_DIRECTORY).sync();
}

void sync(const fs::path& file) { Descriptor(file, O_RDONLY).sync(); }

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) fail("folder", folder, failed.message());
}

void check_folder(const fs::path& folder) {
  fs::path there = fs::absolute(folder);
  std::error_code failed;
  while (!fs::exists(there, failed) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, failed)) fail("folder", folder, "'" + there.string() + "' is no folder");
  if (access(there.c_str(), W_OK) != 0) fail("folder", folder, std::generic_category().message(errno));
}

}  // namespace tandem::output
