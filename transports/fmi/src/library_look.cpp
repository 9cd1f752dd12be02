// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "library_look.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <vector>

namespace tandem::fmi {
namespace {

constexpr std::uint64_t longest_library = std::uint64_t{1} << 30;  // bytes

#if defined(__x86_64__)
constexpr Elf64_Half machine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half machine = EM_AARCH64;
#else
constexpr Elf64_Half machine = EM_386;
#endif

bool is_for_this_processor(const std::string& bytes) {
  Elf64_Ehdr head{};  // of 32 bits it begins alike
  if (bytes.size() < sizeof head) return false;
  std::memcpy(&head, bytes.data(), sizeof head);
  return std::memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 && head.e_type == ET_DYN &&
         head.e_machine == machine;
}

/// A name in the table of symbols ends with a zero; it may be the end of a longer one.
bool has(const std::string& bytes, const std::string& name) {
  return bytes.find(name + '\0') != std::string::npos;
}

std::vector<std::string> main_functions(const Fmu& fmu) {
  const bool exchange = fmu.settings.kind == Kind::model_exchange;
  if (fmu.description.version == Version::two)
    return {"fmi2Instantiate", exchange ? "fmi2GetDerivatives" : "fmi2DoStep"};
  if (exchange) return {"fmi3InstantiateModelExchange", "fmi3GetContinuousStateDerivatives"};
  return {"fmi3InstantiateCoSimulation", "fmi3DoStep"};
}

}  // namespace

std::string library_obstacle(const Fmu& fmu) {
  const std::string library = library_of(fmu);
  if (!fmu.archive->has(library))
    return fmt::format("has no library for this platform, {}; there are those of {}", library,
                       fmu.archive->folders_in("binaries/"));
  const std::string bytes = fmu.archive->text(library, longest_library);
  if (!is_for_this_processor(bytes))
    return fmt::format("has {}, which is no shared library for this processor; allowed is one", library);
  for (const std::string& name : main_functions(fmu))
    if (!has(bytes, name))
      return fmt::format("has {}, which lacks the function {}; allowed is one with it", library, name);
  return {};
}

}  // namespace tandem::fmi
