// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/page.hpp"

#include <cstdint>
#include <string_view>

#include "tandem/error.hpp"

#ifdef TANDEM_VIEW_PAGE
// The file goes into the program as it is; a string literal of a megabyte is not portable.
asm(".section .rodata\n"
    "tandem_view_page: .incbin \"" TANDEM_VIEW_PAGE
    "\"\n"
    "tandem_view_page_end: .byte 0\n"
    ".previous\n");
extern "C" __attribute__((visibility("hidden"))) const char tandem_view_page[], tandem_view_page_end[];
#endif

namespace tandem::view {
namespace {

std::string_view frame() {
#ifdef TANDEM_VIEW_PAGE
  return {tandem_view_page, static_cast<std::size_t>(tandem_view_page_end - tandem_view_page)};
#else
  throw Error(ErrorCode::not_supported,
              "tandem was built without the libraries of the page; install the packages libjs-three and "
              "libjs-dygraphs, and build it again");
#endif
}

/// JSON that can stand in a script element: no "<" begins a tag there.
std::string in_script(const nlohmann::ordered_json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    c == '<' ? void(text += "\\u003c") : text.push_back(c);
  return text;
}

}  // namespace

void check_page() { frame(); }

std::string page(const nlohmann::ordered_json& data) {
  constexpr std::string_view mark = "@tandem_data@";
  std::string text(frame());
  return text.replace(text.find(mark), mark.size(), in_script(data));
}

}  // namespace tandem::view
