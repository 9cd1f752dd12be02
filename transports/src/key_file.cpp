// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/transports/key_file.hpp"

#include <cstdlib>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem {
namespace {

/// A credential of a unit of systemd: from version 254 on the unit's user may read it by an access list,
/// which a mode shows as a right of the group (github.com/systemd/systemd/issues/29435). Who starts the
/// program names its folder, which nobody else can enter.
bool is_credential(const std::filesystem::path& file) {
  const char* const folder = std::getenv("CREDENTIALS_DIRECTORY");
  return folder && file.parent_path() == std::filesystem::path(folder);
}

}  // namespace

std::string read_key_file(const std::filesystem::path& file, bool secret, const std::string& what) {
  constexpr std::uint64_t longest = 1U << 20;
  InputFile in(file, what);
  const unsigned allowed = is_credential(file) ? 0040U : 0U;
  if (secret && (in.rights_of_others() & ~allowed) != 0)
    throw Error(ErrorCode::input_output,
                what + " '" + file.string() + "' may be read by others than its owner; allowed is mode 600");
  return in.rest(longest);
}

}  // namespace tandem
