// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "document.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/fmi/packed_file.hpp"
#include "tandem/input_file.hpp"

namespace tandem::ssp {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t longest = std::uint64_t{1} << 26;
constexpr std::string_view annotation_type = "org.tandem.coordination";

/// Bytes that follow a first one are as many as that says.
bool is_utf8(std::string_view text) {
  for (std::size_t k = 0; k < text.size();) {
    const auto byte = static_cast<unsigned char>(text[k++]);
    int more = byte < 0x80 ? 0 : byte >> 5 == 0x6 ? 1 : byte >> 4 == 0xe ? 2 : byte >> 3 == 0x1e ? 3 : -1;
    if (more < 0 || byte == 0) return false;
    for (; more > 0; --more, ++k)
      if (k == text.size() || static_cast<unsigned char>(text[k]) >> 6 != 0x2) return false;
  }
  return true;
}

std::string read(const fs::path& file) {
  std::string text = read_file(fmi::PackedFile(file).on_disk(), longest);
  if (!is_utf8(text))
    throw Error(ErrorCode::invalid_argument,
                file.string() + ": the text is no UTF-8, which the standard wants");
  return text;
}

/// "My%20motor.fmu" as "My motor.fmu"; empty for what is no such text.
std::string decoded(std::string_view uri) {
  std::string text;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    if (uri[k] != '%') {
      text += uri[k];
      continue;
    }
    unsigned byte = 0;
    const auto digits = uri.substr(k + 1, 2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (error != std::errc() || digits.size() < 2 || end != digits.data() + 2 || byte < 0x20) return "";
    text += static_cast<char>(byte);
    k += 2;
  }
  return text;
}

bool lies_in(const fs::path& file, const fs::path& archive) {
  return std::mismatch(archive.begin(), archive.end(), file.begin(), file.end()).first == archive.end();
}

}  // namespace

fs::path description_in(const fs::path& archive) { return archive / "SystemStructure.ssd"; }

xml_node type_of(xml_node one) {
  for (const xml_node child : one) {
    const std::string_view name = fmi::local_name(child);
    const bool other = name == "ConnectorGeometry" || name == "Annotations" || name == "Dimension" ||
                       name == "MetaData" || name == "Signature";
    if (!other) return child;
  }
  return {};
}

Definitions read_definitions(const fmi::Xml& xml, xml_node of) {
  Definitions to{fmi::read_units(xml, xml.only(of, "Units")), {}};
  for (const xml_node one : fmi::children(xml.only(of, "Enumerations"), "Enumeration"))
    for (const xml_node item : fmi::children(one, "Item"))
      to.enumerations[xml.text(one, "name").value_or("")][xml.needed_text(item, "name")] =
          xml.number(item, "value").value_or(0.0);
  return to;
}

const Document& Documents::open(const fs::path& file, std::string_view root) {
  auto& known = all_[file];
  if (!known) known = std::make_unique<Document>(file, root, *this);
  return *known;
}

Document::Document(fs::path path, std::string_view name, Documents& all)
    : file(std::move(path)),
      text(read(file)),
      shown(file.string()),
      xml(text, shown),
      root(xml.root(name)),
      others(all) {
  const std::string version = xml.needed_text(root, "version");
  if (!version.starts_with("1.") && !version.starts_with("2.")) xml.wrong(root, "version", "1.0 or 2.0");
  defined = read_definitions(xml, root);
}

fs::path Document::beside(xml_node of, const char* attribute) const {
  const std::string path = decoded(xml.needed_text(of, attribute));
  if (path.empty() || path.front() == '/' || path.find_first_of("?#%\\:") != std::string::npos)
    xml.wrong(of, attribute, "the relative path of a file in this system, without ? # % \\ and :");
  const fs::path there = (file.parent_path() / path).lexically_normal(), holder = fmi::outermost(file);
  if (holder != file && !lies_in(there, holder.lexically_normal()))
    xml.wrong(of, attribute, "the path of a file in this archive");
  return there;
}

std::map<std::string, std::string> own_annotation(const Document& document, xml_node of) {
  std::map<std::string, std::string> all;
  for (const xml_node one : fmi::children(fmi::child(of, "Annotations"), "Annotation")) {
    if (one.attribute("type").value() != annotation_type) continue;
    const xml_node content = one.first_child();
    for (const pugi::xml_attribute attribute : content.attributes()) {
      const std::string_view name = attribute.name();
      if (!name.starts_with("xmlns")) all[std::string(name.substr(name.find(':') + 1))] = attribute.value();
    }
    if (all.empty()) document.xml.refuse(one, "the annotation holds no element with attributes");
  }
  return all;
}

}  // namespace tandem::ssp
