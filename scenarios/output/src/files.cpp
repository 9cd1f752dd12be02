// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "tandem/error.hpp"
#include "tandem/output_file.hpp"

namespace tandem::output {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw Error(ErrorCode::input_output,
              what + " '" + path.string() + "' can't be " + (what == "file" ? "written: " : "made: ") + why);
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Puts a folder's names on the disk.
void sync_folder(const fs::path& folder) {
  const int number = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool done = number >= 0 && ::fsync(number) == 0;
  const int why = errno;
  if (number >= 0) ::close(number);
  if (!done) fail("file", folder, std::generic_category().message(why));
}

/// What stands there is a regular file, or nothing: a rename would take the place of anything else too.
void check_replaced(const fs::path& file) {
  std::error_code ignored;
  const auto status = fs::status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
    fail("file", file, fs::is_directory(status) ? "there is a folder" : "what is there is no regular file");
}

/// An error's sentence with the name that the user knows in place of that of FILE.part.
std::string of_whole(std::string sentence, const fs::path& file) {
  const std::string part = part_of(file).string();
  if (const auto at = sentence.find(part); at != std::string::npos)
    sentence.replace(at, part.size(), file.string());
  return sentence;
}

[[noreturn]] void throw_of_whole(const fs::path& file) try { throw; } catch (const NoRoom& error) {
  throw NoRoom(of_whole(error.what(), file));
} catch (const Error& error) {
  throw Error(error.code(), of_whole(error.what(), file));
}

/// Writes FILE.part and renames it; whatever goes wrong, no FILE.part is left.
void replace(const fs::path& file, std::string_view text, bool durably) {
  check_replaced(file);
  if (const fs::path folder = fs::absolute(file).parent_path(); !fs::is_directory(folder))
    fail("file", file, "there is no folder '" + file.parent_path().string() + "'");
  const fs::path part = part_of(file);
  if (fs::is_directory(part)) fail("file", file, "there is a folder '" + part.string() + "'");
  remove_part(file);
  try {
    OutputFile out(part, OutputFile::Begin::fresh);
    out.write(text);
    if (durably) out.sync();
    out.close();
    std::error_code failed;
    fs::rename(part, file, failed);
    if (failed) fail("file", file, failed.message());
  } catch (...) {
    remove_part(file);
    throw_of_whole(file);
  }
  if (durably) sync_folder(fs::absolute(file).parent_path());
}

}  // namespace

void write_text(const fs::path& file, const std::string& text) {
  OutputFile out(file, OutputFile::Begin::empty);
  try {
    out.write(text);
    out.close();
  } catch (...) {
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);  // half a text is of no use
    throw;
  }
}

fs::path part_of(const fs::path& file) { return fs::path(file) += ".part"; }

void remove_part(const fs::path& file) noexcept { ::unlink(part_of(file).c_str()); }

void replace_text(const fs::path& file, const std::string& text) { replace(file, text, false); }

void replace_durably(const fs::path& file, std::span<const std::byte> bytes) {
  replace(file, text_of(bytes), true);
}

void sync(const fs::path& file) { OutputFile(file, OutputFile::Begin::kept).sync(); }

void make_folder(const fs::path& folder) {
  std::error_code failed;
  if (fs::exists(folder, failed) && !fs::is_directory(folder, failed))
    fail("folder", folder, "there is a file of that name");
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
