// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/printable.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "printable_table.hpp"

namespace tandem::test {
namespace {

std::string byte_text(unsigned code) {
  constexpr char digits[] = "0123456789abcdef";
  return {'\\', 'x', digits[code / 16], digits[code % 16]};
}

/// The shortest form of UTF-8, by its table of bits (RFC 3629, section 3).
std::string in_utf8(std::uint32_t code) {
  const auto part = [&](unsigned shift) { return static_cast<char>(0x80U | (code >> shift & 0x3fU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xc0U | code >> 6U), part(0)};
  if (code < 0x10000) return {static_cast<char>(0xe0U | code >> 12U), part(6), part(0)};
  return {static_cast<char>(0xf0U | code >> 18U), part(12), part(6), part(0)};
}

/// Of each character by itself: what has to be there.
std::string expected_of(std::uint32_t code) {
  const std::string bytes = in_utf8(code);
  if (code >= 0xd800 && code <= 0xdfff) {  // no characters
    std::string shown;
    for (const char c : bytes) shown += byte_text(static_cast<unsigned char>(c));
    return shown;
  }
  if (code < 0x20 || code == 0x7f) return byte_text(code);
  constexpr std::uint32_t turning[] = {0x61c,  0x200e, 0x200f, 0x2028, 0x2029, 0x202a, 0x202b,
                                       0x202c, 0x202d, 0x202e, 0x2066, 0x2067, 0x2068, 0x2069};
  if ((code >= 0x80 && code < 0xa0) ||
      std::find(std::begin(turning), std::end(turning), code) != std::end(turning))
    return "\\u" + byte_text(code >> 8U).substr(2) + byte_text(code & 0xffU).substr(2);
  return bytes;
}

TEST(Printable, EachCharacterIsShownAsItIsOrEscapedAsAControlCharacter) {
  for (std::uint32_t code = 0; code <= 0x10ffff; ++code)
    ASSERT_EQ(printable(in_utf8(code)), expected_of(code)) << std::hex << code;
}

TEST(Printable, TheTableOfStrangersTexts) {
  for (const auto& [text, shown] : printable_table()) EXPECT_EQ(printable(text), shown);
}

/// The bytes that a character of UTF-8 has here, by the grammar of RFC 3629, section 4; 0 if there is none.
std::size_t by_the_grammar(const std::string& text) {
  struct Form {
    std::vector<std::pair<int, int>> bytes;
  };
  static const std::vector<Form> forms = {{{{0x00, 0x7f}}},
                                          {{{0xc2, 0xdf}, {0x80, 0xbf}}},
                                          {{{0xe0, 0xe0}, {0xa0, 0xbf}, {0x80, 0xbf}}},
                                          {{{0xe1, 0xec}, {0x80, 0xbf}, {0x80, 0xbf}}},
                                          {{{0xed, 0xed}, {0x80, 0x9f}, {0x80, 0xbf}}},
                                          {{{0xee, 0xef}, {0x80, 0xbf}, {0x80, 0xbf}}},
                                          {{{0xf0, 0xf0}, {0x90, 0xbf}, {0x80, 0xbf}, {0x80, 0xbf}}},
                                          {{{0xf1, 0xf3}, {0x80, 0xbf}, {0x80, 0xbf}, {0x80, 0xbf}}},
                                          {{{0xf4, 0xf4}, {0x80, 0x8f}, {0x80, 0xbf}, {0x80, 0xbf}}}};
  for (const Form& form : forms) {
    bool fits = text.size() >= form.bytes.size();
    for (std::size_t k = 0; fits && k < form.bytes.size(); ++k) {
      const int byte = static_cast<unsigned char>(text[k]);
      fits = byte >= form.bytes[k].first && byte <= form.bytes[k].second;
    }
    if (fits) return form.bytes.size();
  }
  return 0;
}

/// What is shown of four bytes: characters of the grammar, and any other byte escaped.
std::string by_the_grammar_shown(std::string text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t bytes = by_the_grammar(text);
    shown += bytes == 0 ? byte_text(static_cast<unsigned char>(text[0])) : printable(text.substr(0, bytes));
    text.erase(0, std::max<std::size_t>(bytes, 1));
  }
  return shown;
}

TEST(Printable, BytesAtEachBorderOfTheGrammarAreTakenAsItSays) {
  const unsigned borders[] = {0x00, 0x41, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xc1, 0xc2, 0xdf,
                              0xe0, 0xe1, 0xec, 0xed, 0xee, 0xef, 0xf0, 0xf1, 0xf3, 0xf4, 0xf5, 0xff};
  for (const unsigned a : borders)
    for (const unsigned b : borders)
      for (const unsigned c : borders)
        for (const unsigned d : borders) {
          const std::string text = {static_cast<char>(a), static_cast<char>(b), static_cast<char>(c),
                                    static_cast<char>(d)};
          ASSERT_EQ(printable(text), by_the_grammar_shown(text)) << std::hex << a << b << c << d;
        }
}

TEST(Printable, WhatIsTooLongIsCutBetweenCharacters) {
  struct Cut {
    std::string text;
    std::size_t longest;
    std::string shown;
  };
  const Cut cuts[] = {{"", 0, ""},
                      {"a", 0, "..."},
                      {"abc", 3, "abc"},
                      {"abcd", 3, "abc..."},
                      {"\u20ac", 3, "\u20ac"},
                      {"a\u20ac", 3, "a..."},
                      {"\u20ac\u20ac", 5, "\u20ac..."},
                      {"\x1b", 4, "\\x1b"},
                      {"\x1b", 3, "..."},
                      {"ab\x1b", 5, "ab..."},
                      {"\u202e", 6, "\\u202e"},
                      {"\u202e", 5, "..."},
                      {"\xff\xff", 7, "\\xff..."},
                      {std::string("\0\0", 2), 8, "\\x00\\x00"}};
  for (const auto& [text, longest, shown] : cuts) EXPECT_EQ(printable(text, longest), shown) << longest;
  EXPECT_EQ(printable(std::string(2001, 'x')), std::string(2000, 'x') + "...");
}

}  // namespace
}  // namespace tandem::test
