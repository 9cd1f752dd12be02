// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "output/files.hpp"

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
  if (!out) fail("file", file, std::generic_category().message(errno));
}

void replace_text(const fs::path& file, const std::string& text) {
  fs::path part = file;
  part += ".part";
  write_text(part, text);
  std::error_code failed;
  fs::rename(part, file, failed);
  if (failed) fail("file", file, failed.message());
}

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
