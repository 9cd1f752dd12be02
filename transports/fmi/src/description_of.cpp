// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/archive.hpp"
#include "tandem/fmi/description.hpp"

namespace tandem::fmi {

Description description_of(const Archive& archive, const std::filesystem::path& file) {
  constexpr std::uint64_t longest = std::uint64_t{1} << 26;
  const std::string name = "modelDescription.xml";
  if (!archive.has(name)) archive.refuse("holds no " + name);
  return read_description(archive.text(name, longest), file.string() + ": " + name);
}

}  // namespace tandem::fmi
