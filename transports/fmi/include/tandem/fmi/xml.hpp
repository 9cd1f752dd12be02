// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::fmi {

/// The name of an element without the prefix of its namespace: "Component" of <ssd:Component>.
std::string_view local_name(pugi::xml_node node);
/// The elements of that name in another, and the first of them; null: there is none.
std::vector<pugi::xml_node> children(pugi::xml_node of, std::string_view name);
pugi::xml_node child(pugi::xml_node of, std::string_view name);

/// The attributes of an XML text's elements, with errors that name file, line, element and attribute.
class Xml {
 public:
  /// Refuses what is no XML, and a document type: nothing outside the text is read, and nothing in it grows.
  /// Views both, which outlive it.
  Xml(std::string_view text, std::string_view file);

  pugi::xml_node root(std::string_view name) const;
  /// The line in which an element begins.
  int line(pugi::xml_node of) const;
  /// The one element of that name in another; null: there is none. Refuses a second.
  pugi::xml_node only(pugi::xml_node of, std::string_view name) const;

  std::optional<std::string> text(pugi::xml_node of, const char* name) const;
  std::string needed_text(pugi::xml_node of, const char* name) const;
  std::optional<double> number(pugi::xml_node of, const char* name) const;
  /// A whole number from `least` to `most`.
  std::optional<std::int64_t> whole(pugi::xml_node of, const char* name, std::int64_t least,
                                    std::int64_t most) const;
  bool flag(pugi::xml_node of, const char* name) const;  ///< false where it is not there
  /// Numbers with blanks between.
  std::optional<std::vector<double>> numbers(pugi::xml_node of, const char* name) const;
  std::vector<bool> flags(pugi::xml_node of, const char* name) const;
  /// Whole numbers.
  std::optional<std::vector<std::int64_t>> list(pugi::xml_node of, const char* name, std::int64_t least,
                                                std::int64_t most) const;
  /// One of some words.
  template <class Meaning>
  Meaning word(pugi::xml_node of, const char* name, const std::map<std::string, Meaning>& words,
               Meaning otherwise) const {
    const auto found = text(of, name);
    if (!found) return otherwise;
    const auto it = words.find(*found);
    if (it != words.end()) return it->second;
    std::string allowed;
    for (const auto& [one, meaning] : words) allowed += (allowed.empty() ? "" : ", ") + one;
    wrong(of, name, allowed);
  }

  [[noreturn]] void wrong(pugi::xml_node of, const char* name, const std::string& allowed) const;
  [[noreturn]] void refuse(pugi::xml_node at, const std::string& sentence) const;

 private:
  int line(std::ptrdiff_t offset) const;
  std::string place(std::ptrdiff_t offset) const;

  std::string_view text_, file_;
  std::vector<std::ptrdiff_t> line_ends_;
  pugi::xml_document document_;
};

}  // namespace tandem::fmi
