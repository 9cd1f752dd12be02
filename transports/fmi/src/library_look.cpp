// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "library_look.hpp"

#include <fmt/format.h>
#include <link.h>  // ElfW

#include <cstring>
#include <optional>
#include <set>
#include <string_view>
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

/// What stands there, if the file goes so far.
template <class T>
std::optional<T> at(std::string_view bytes, std::uint64_t place) {
  T value;
  if (place > bytes.size() || bytes.size() - place < sizeof value) return {};
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

std::string_view part(std::string_view bytes, const ElfW(Shdr) & section) {
  return section.sh_offset > bytes.size() ? std::string_view()
                                          : bytes.substr(section.sh_offset, section.sh_size);
}

void add_defined(std::string_view symbols, std::string_view strings, std::set<std::string_view>& to) {
  for (std::uint64_t k = 0; const auto symbol = at<ElfW(Sym)>(symbols, k); k += sizeof *symbol)
    if (symbol->st_shndx != SHN_UNDEF && symbol->st_name < strings.size()) {
      const std::string_view rest = strings.substr(symbol->st_name);
      to.insert(rest.substr(0, rest.find('\0')));
    }
}

/// The names that a library defines for others, by its sections of dynamic symbols.
std::set<std::string_view> defined_names(std::string_view bytes) {
  std::set<std::string_view> names;
  const auto head = at<ElfW(Ehdr)>(bytes, 0);
  const auto section = [&](std::uint64_t number) {
    return at<ElfW(Shdr)>(bytes, head->e_shoff + number * sizeof(ElfW(Shdr)));
  };
  for (int k = 0; head && head->e_shoff < bytes.size() && k < head->e_shnum; ++k)
    if (const auto one = section(static_cast<std::uint64_t>(k)); one && one->sh_type == SHT_DYNSYM)
      if (const auto strings = section(one->sh_link))
        add_defined(part(bytes, *one), part(bytes, *strings), names);
  return names;
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
  const auto defined = defined_names(bytes);
  for (const std::string& name : main_functions(fmu))
    if (!defined.contains(name))
      return fmt::format("has {}, which lacks the function {}; allowed is one with it", library, name);
  return {};
}

}  // namespace tandem::fmi
