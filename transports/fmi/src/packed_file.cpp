// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/packed_file.hpp"

#include "tandem/error.hpp"
#include "tandem/fmi/archive.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {

namespace fs = std::filesystem;

fs::path outermost(const fs::path& file) {
  fs::path part;
  for (const fs::path& step : file)
    if (std::error_code failed; fs::is_regular_file(part /= step, failed)) return part;
  return file;
}

PackedFile::PackedFile(const fs::path& file) : there_(file) {
  for (fs::path holder = outermost(there_); holder != there_; holder = outermost(there_)) {
    const std::string inside = there_.lexically_relative(holder).generic_string();
    Archive archive(holder, "archive");
    const std::string name = archive.file_in(inside);
    if (name.empty())
      throw Error(ErrorCode::input_output, "file '" + file.string() + "' is not there: '" + holder.string() +
                                               "' holds no '" + printable(inside, 200) + "'");
    auto folder = std::make_unique<TemporaryFolder>();
    archive.unpack_file(name, folder->path());
    there_ = folder->path() / inside;
    folder_ = std::move(folder);
  }
}

}  // namespace tandem::fmi
