// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/key_file.hpp"

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem {

std::string read_key_file(const std::filesystem::path& file, bool secret, const std::string& what) {
  constexpr std::uint64_t longest = 1U << 20;
  InputFile in(file, what);
  if (secret && in.open_to_others())
    throw Error(ErrorCode::input_output,
                what + " '" + file.string() + "' may be read by others than its owner; allowed is mode 600");
  return in.rest(longest);
}

}  // namespace tandem
