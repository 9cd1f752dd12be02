// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/xml.hpp"

#include <algorithm>
#include <charconv>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> all;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const auto end = std::min(text.find_first_of(blanks), text.size());
    all.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return all;
}

const std::map<std::string, bool>& flag_words() {
  static const std::map<std::string, bool> all = {
      {"true", true}, {"1", true}, {"false", false}, {"0", false}};
  return all;
}

/// The whole of a text as a number. A plus before it is allowed by XML.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string_view local_name(pugi::xml_node node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

std::vector<pugi::xml_node> children(pugi::xml_node of, std::string_view name) {
  std::vector<pugi::xml_node> all;
  for (const pugi::xml_node node : of)
    if (local_name(node) == name) all.push_back(node);
  return all;
}

pugi::xml_node child(pugi::xml_node of, std::string_view name) {
  for (const pugi::xml_node node : of)
    if (local_name(node) == name) return node;
  return {};
}

Xml::Xml(std::string_view text, std::string_view file) : text_(text), file_(file) {
  for (std::size_t k = 0; k < text.size(); ++k)
    if (text[k] == '\n') line_ends_.push_back(static_cast<std::ptrdiff_t>(k));
  const auto result =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
  if (!result)
    throw Error(ErrorCode::invalid_argument,
                place(result.offset) + ": this is no well-formed XML: " + result.description());
  for (const pugi::xml_node node : document_)
    if (node.type() == pugi::node_doctype) refuse(node, "a document type stands here; allowed is none");
}

pugi::xml_node Xml::root(std::string_view name) const {
  const pugi::xml_node node = document_.document_element();
  if (local_name(node) != name)
    refuse(node,
           "the document is <" + printable(node.name(), 100) + ">; allowed is <" + std::string(name) + ">");
  return node;
}

int Xml::line(std::ptrdiff_t offset) const {
  const auto it = std::lower_bound(line_ends_.begin(), line_ends_.end(), offset);
  return static_cast<int>(1 + (it - line_ends_.begin()));
}

pugi::xml_node Xml::only(pugi::xml_node of, std::string_view name) const {
  const auto all = children(of, name);
  if (all.size() > 1) refuse(all[1], "<" + printable(all[1].name(), 100) + "> is there twice; allowed is once");
  return all.empty() ? pugi::xml_node() : all[0];
}

int Xml::line(pugi::xml_node of) const { return line(of.offset_debug()); }

std::string Xml::place(std::ptrdiff_t offset) const {
  return std::string(file_) + ":" + std::to_string(line(offset));
}

void Xml::refuse(pugi::xml_node at, const std::string& sentence) const {
  throw Error(ErrorCode::invalid_argument, place(at.offset_debug()) + ": " + sentence);
}

void Xml::wrong(pugi::xml_node of, const char* name, const std::string& allowed) const {
  const auto found = of.attribute(name);
  refuse(of, std::string("attribute ") + name + " of <" + printable(of.name(), 100) + "> is " +
                 (found ? "'" + printable(found.value(), 200) + "'" : "not there") + "; allowed is " +
                 allowed);
}

std::optional<std::string> Xml::text(pugi::xml_node of, const char* name) const {
  const auto found = of.attribute(name);
  return found ? std::optional<std::string>(found.value()) : std::nullopt;
}

std::string Xml::needed_text(pugi::xml_node of, const char* name) const {
  const auto found = of.attribute(name);
  if (!found || *found.value() == '\0') wrong(of, name, "a text");
  return found.value();
}

std::optional<double> Xml::number(pugi::xml_node of, const char* name) const {
  const auto found = of.attribute(name);
  if (!found) return std::nullopt;
  const auto value = number_of<double>(found.value());
  if (!value) wrong(of, name, "a number");
  return value;
}

std::optional<std::int64_t> Xml::whole(pugi::xml_node of, const char* name, std::int64_t least,
                                       std::int64_t most) const {
  const auto found = of.attribute(name);
  if (!found) return std::nullopt;
  const auto value = number_of<std::int64_t>(found.value());
  if (!value || *value < least || *value > most)
    wrong(of, name, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value;
}

bool Xml::flag(pugi::xml_node of, const char* name) const {
  return word<bool>(of, name, flag_words(), false);
}

std::optional<std::vector<double>> Xml::numbers(pugi::xml_node of, const char* name) const {
  const auto found = of.attribute(name);
  if (!found) return std::nullopt;
  std::vector<double> all;
  for (const std::string_view word : words(found.value())) {
    const auto value = number_of<double>(word);
    if (!value) wrong(of, name, "numbers with blanks between");
    all.push_back(*value);
  }
  return all;
}

std::vector<bool> Xml::flags(pugi::xml_node of, const char* name) const {
  std::vector<bool> all;
  for (const std::string_view word : words(of.attribute(name).value())) {
    const auto it = flag_words().find(std::string(word));
    if (it == flag_words().end()) wrong(of, name, "0, 1, false, true, with blanks between");
    all.push_back(it->second);
  }
  return all;
}

std::optional<std::vector<std::int64_t>> Xml::list(pugi::xml_node of, const char* name, std::int64_t least,
                                                   std::int64_t most) const {
  const auto found = of.attribute(name);
  if (!found) return std::nullopt;
  std::vector<std::int64_t> all;
  for (const std::string_view word : words(found.value())) {
    const auto value = number_of<std::int64_t>(word);
    if (!value || *value < least || *value > most)
      wrong(of, name,
            "a list of whole numbers from " + std::to_string(least) + " to " + std::to_string(most));
    all.push_back(*value);
  }
  return all;
}

}  // namespace tandem::fmi
