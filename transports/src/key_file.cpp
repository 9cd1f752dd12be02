// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/key_file.hpp"

#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "tandem/error.hpp"

namespace tandem {

std::string read_key_file(const std::filesystem::path& file, bool secret) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0)
    throw Error(ErrorCode::input_output, "key file '" + file.string() + "' is not there");
  if (secret && (status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    throw Error(ErrorCode::input_output,
                "key file '" + file.string() + "' may be read by others than its owner; allowed is mode 600");
  std::ifstream in(file, std::ios::binary);
  if (!in || !S_ISREG(status.st_mode))
    throw Error(ErrorCode::input_output, "key file '" + file.string() + "' can't be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace tandem
