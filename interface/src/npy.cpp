// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/npy.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string_view>

#include "tandem/error.hpp"

namespace tandem {
namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::size_t before_text = 12;  // magic, version, u32 length
constexpr std::size_t digits_of_rows = 20;

[[noreturn]] void refuse_head(const std::string& why) { throw Error(ErrorCode::input_output, why); }

/// A literal of Python's.
std::string quoted(const std::string& text) {
  std::string to = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') to += '\\';
    to += c;
  }
  return to + "'";
}

/// The text of a head: what Python's literals it has, one after the other.
class Literals {
 public:
  explicit Literals(std::string_view text) : rest_(text) {}

  bool takes(std::string_view token) {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) rest_.remove_prefix(1);
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  void take(std::string_view token) {
    if (!takes(token)) refuse_head("its head has no " + std::string(token) + " where it has to be");
  }
  std::string text() {
    take("'");
    std::string to;
    for (; !rest_.empty() && rest_[0] != '\''; rest_.remove_prefix(1)) {
      if (rest_[0] == '\\') rest_.remove_prefix(1);
      if (!rest_.empty()) to += rest_[0];
    }
    take("'");
    return to;
  }
  std::uint64_t number() {
    takes("");
    std::uint64_t value = 0;
    const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (code != std::errc{}) refuse_head("its head has no number of rows");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

 private:
  std::string_view rest_;
};

void read_types(Literals& from, NpyHead& to) {
  from.take("[");
  while (from.takes("(")) {
    to.names.push_back(from.text());
    from.take(",");
    if (const std::string type = from.text(); type != "<f8")
      refuse_head("column " + std::to_string(to.names.size()) + " is of another type; allowed is <f8");
    from.take(")");
    from.takes(",");
  }
  from.take("]");
}

/// In any order, as Python has them.
void read_entries(Literals& from, NpyHead& to) {
  from.take("{");
  while (!from.takes("}")) {
    const std::string key = from.text();
    from.take(":");
    if (key == "descr") {
      read_types(from, to);
    } else if (key == "shape") {
      from.take("(");
      to.rows = from.number();
      from.take(",");
      from.take(")");
    } else {
      from.take("False");  // fortran_order
    }
    from.takes(",");
  }
}

}  // namespace

std::string npy_head(const std::vector<std::string>& names, std::uint64_t rows) {
  std::string text = "{'descr': [";
  for (const std::string& name : names) text += "(" + quoted(name) + ", '<f8'), ";
  const std::string number = std::to_string(rows);
  text += "], 'fortran_order': False, 'shape': (" + std::string(digits_of_rows - number.size(), ' ') +
          number + ",), }";
  const std::size_t all = (before_text + text.size() + 1 + 63) / 64 * 64;
  text.append(all - before_text - text.size() - 1, ' ');
  text += '\n';
  std::string head(magic);
  head += '\x03';
  head += '\0';
  for (int byte = 0; byte < 4; ++byte) head += static_cast<char>(text.size() >> (8 * byte) & 0xFF);
  return head + text;
}

NpyHead read_npy_head(std::span<const std::byte> bytes) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (all.size() < before_text || !all.starts_with(magic))
    refuse_head("it does not begin as a file of numpy does");
  const int version = all[magic.size()];
  if (version < 1 || version > 3)
    refuse_head("it is of version " + std::to_string(version) + " of numpy's format; allowed are 1 to 3");
  const std::size_t width = version == 1 ? 2 : 4, begin = magic.size() + 2 + width;
  std::size_t length = 0;
  for (std::size_t byte = 0; byte < width; ++byte)
    length |= static_cast<std::size_t>(static_cast<unsigned char>(all[magic.size() + 2 + byte]))
              << (8 * byte);
  if (length > all.size() - begin) refuse_head("its head is cut off");
  NpyHead head;
  Literals text(all.substr(begin, length));
  read_entries(text, head);
  head.size = begin + length;
  return head;
}

}  // namespace tandem
