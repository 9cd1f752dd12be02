// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "zip.hpp"

#include <minizip/zip.h>

#include <cerrno>
#include <memory>
#include <system_error>

#include "tandem/error.hpp"

namespace tandem::exported {
namespace {

[[noreturn]] void fail(const std::filesystem::path& archive) {
  const int why = errno;
  const std::string sentence =
      "archive '" + archive.string() + "' can't be written: " + std::generic_category().message(why);
  if (why == ENOSPC || why == EDQUOT || why == EFBIG) throw NoRoom(sentence);
  throw Error(ErrorCode::input_output, sentence);
}

struct Close {
  void operator()(void* zip) const { zipClose(zip, nullptr); }
};

/// Of 1 January 1980, the first day that the format knows, and readable by all.
zip_fileinfo plain() {
  zip_fileinfo info{};
  info.tmz_date = {0, 0, 0, 1, 0, 1980};
  info.external_fa = 0100644ul << 16;
  return info;
}

}  // namespace

void write_zip(const std::filesystem::path& archive, const std::map<std::string, std::string>& contents) {
  constexpr int made_by_unix = 3 << 8;
  constexpr uLong names_are_utf8 = 1u << 11;
  std::unique_ptr<void, Close> zip(zipOpen64(archive.c_str(), APPEND_STATUS_CREATE));
  if (!zip) fail(archive);
  constexpr int memory_level = 7;  // blocks of code, which differ, are smaller so than with zlib's own 8
  const zip_fileinfo info = plain();
  for (const auto& [name, text] : contents) {
    const bool done =
        zipOpenNewFileInZip4_64(zip.get(), name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                                Z_BEST_COMPRESSION, 0, -MAX_WBITS, memory_level, Z_DEFAULT_STRATEGY, nullptr,
                                0, made_by_unix, names_are_utf8, 0) == ZIP_OK &&
        zipWriteInFileInZip(zip.get(), text.data(), static_cast<unsigned>(text.size())) == ZIP_OK &&
        zipCloseFileInZip(zip.get()) == ZIP_OK;
    if (!done) fail(archive);
  }
  if (zipClose(zip.release(), nullptr) != ZIP_OK) fail(archive);
}

}  // namespace tandem::exported
