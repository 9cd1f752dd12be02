// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace tandem {

/// The text of a file that holds a key or a certificate; `what` is how errors call it. Throws
/// Error(input_output) that names the file if it can't be read, as of a FIFO, and, of a `secret` one, if
/// others than its owner may read it.
std::string read_key_file(const std::filesystem::path& file, bool secret,
                          const std::string& what = "key file");

}  // namespace tandem
