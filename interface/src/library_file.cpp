// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/library_file.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem {
namespace {

using Header = ElfW(Ehdr);
using LoadedPart = ElfW(Phdr);

template <class T>
bool take(InputFile& in, std::span<T> to) {
  return in.read(std::as_writable_bytes(to)) == to.size_bytes();
}

/// Bytes that the file must have for its segments; 0 if that can't be told from what is there of it.
std::uint64_t size_of_segments(InputFile& in, const Header& header) {
  std::vector<LoadedPart> segments(header.e_phnum);
  in.seek(header.e_phoff);
  if (header.e_phentsize != sizeof(LoadedPart) || !take(in, std::span(segments))) return 0;
  std::uint64_t end = 0;
  for (const LoadedPart& s : segments)
    if (s.p_type == PT_LOAD) end = std::max<std::uint64_t>(end, std::uint64_t{s.p_offset} + s.p_filesz);
  return end;
}

bool is_elf(const Header& header) {
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
         header.e_ident[EI_CLASS] == (sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32);
}

/// Whether it lies in a part of a loaded file that can be executed.
bool is_code(const void* address) {
  struct Asked {
    std::uintptr_t place;
    bool found;
  } asked{reinterpret_cast<std::uintptr_t>(address), false};
  const auto look = [](dl_phdr_info* file, std::size_t, void* data) {
    Asked& of = *static_cast<Asked*>(data);
    for (const LoadedPart& s : std::span(file->dlpi_phdr, file->dlpi_phnum))
      if (s.p_type == PT_LOAD && (s.p_flags & PF_X) != 0)
        of.found = of.found || of.place - (file->dlpi_addr + s.p_vaddr) < s.p_memsz;
    return of.found ? 1 : 0;
  };
  ::dl_iterate_phdr(look, &asked);
  return asked.found;
}

/// Of constants, which may lie beside code.
bool is_object(const void* address) {
  Dl_info info{};
  const ElfW(Sym)* symbol = nullptr;
  void* const entry = static_cast<void*>(&symbol);
  return ::dladdr1(address, &info, static_cast<void**>(entry), RTLD_DL_SYMENT) != 0 && symbol &&
         info.dli_saddr == address && ELF64_ST_TYPE(symbol->st_info) == STT_OBJECT;
}

}  // namespace

void check_library_file(const std::filesystem::path& file, const std::string& name) {
  InputFile in(file, "library");
  Header header{};
  const bool whole_header = take(in, std::span(&header, 1));
  if (!is_elf(header) || (whole_header && header.e_type != ET_DYN)) return;  // the loader says so
  const std::uint64_t size = whole_header ? size_of_segments(in, header) : 0;
  if (size == 0 || in.size() < size)
    throw Error(ErrorCode::input_output,
                name + " is truncated: it has " + std::to_string(in.size()) + " bytes; allowed are " +
                    std::to_string(std::max<std::uint64_t>(size, sizeof(Header))) + " or more");
}

void check_function(const void* address, const std::string& library, const std::string& symbol) {
  if (is_code(address) && !is_object(address)) return;
  throw Error(ErrorCode::invalid_argument,
              library + ": symbol '" + symbol + "' is data; allowed is a function");
}

}  // namespace tandem
