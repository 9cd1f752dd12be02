// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <minizip/zip.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace tandem::test {

/// A file in a zip archive, whatever its name.
struct Packed {
  std::string name, content;
  unsigned mode = 0100644;  ///< as Unix has it
};

inline std::filesystem::path write_zip(const std::filesystem::path& file, const std::vector<Packed>& all) {
  const zipFile zip = zipOpen64(file.c_str(), APPEND_STATUS_CREATE);
  if (!zip) throw std::runtime_error("no archive");
  for (const Packed& one : all) {
    zip_fileinfo info{};
    info.external_fa = static_cast<uLong>(one.mode) << 16;
    constexpr uLong made_by_unix = 3U << 8;
    zipOpenNewFileInZip4_64(zip, one.name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, 6, 0,
                            -MAX_WBITS, DEF_MEM_LEVEL, Z_DEFAULT_STRATEGY, nullptr, 0, made_by_unix, 0, 0);
    zipWriteInFileInZip(zip, one.content.data(), static_cast<unsigned>(one.content.size()));
    zipCloseFileInZip(zip);
  }
  zipClose(zip, nullptr);
  return file;
}

}  // namespace tandem::test
