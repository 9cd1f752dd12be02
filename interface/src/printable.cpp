// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/printable.hpp"

#include <cstdint>

namespace tandem {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< that it takes; 0: no UTF-8
};

/// The first character (RFC 3629, section 4): shortest form, no surrogates, up to U+10FFFF.
Character first(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7fU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xc0U) != 0x80) return {};
    code = code << 6U | (byte(k) & 0x3fU);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
  return {code, bytes};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c ||
         (code >= 0x200e && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::string escaped(char letter, std::uint32_t code, int digits) {
  std::string text = {'\\', letter};
  for (int k = digits - 1; k >= 0; --k) text += "0123456789abcdef"[code >> 4 * k & 15];
  return text;
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  while (!text.empty()) {
    const Character c = first(text);
    const std::string one = c.bytes == 0          ? escaped('x', static_cast<unsigned char>(text[0]), 2)
                            : !is_control(c.code) ? std::string(text.substr(0, c.bytes))
                            : c.code < 0x80       ? escaped('x', c.code, 2)
                                                  : escaped('u', c.code, 4);
    if (shown.size() + one.size() > longest) return shown + "...";
    shown += one;
    text.remove_prefix(c.bytes == 0 ? 1 : c.bytes);
  }
  return shown;
}

std::string printable_lines(std::string_view text) {
  std::string shown;
  for (std::size_t end = 0; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1))
    shown += printable(text.substr(0, end), text.npos) + '\n';
  return shown + printable(text, text.npos);
}

}  // namespace tandem
