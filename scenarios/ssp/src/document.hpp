// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "tandem/fmi/unit_definitions.hpp"
#include "tandem/fmi/xml.hpp"

namespace tandem::ssp {

using pugi::xml_node;

/// The units and enumerations that a file defines.
struct Definitions {
  std::map<std::string, std::string> units;                           ///< by name, as tandem writes them
  std::map<std::string, std::map<std::string, double>> enumerations;  ///< by name, by item
};
Definitions read_definitions(const fmi::Xml& xml, xml_node of);

/// One XML file of a system: a description (.ssd), or a set of values (.ssv). It may lie in an archive.
class Documents;
struct Document {
  /// root: the element that it has to be. others: where those beside it are kept. Throws Error that names the
  /// file.
  Document(std::filesystem::path file, std::string_view root, Documents& others);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  std::filesystem::path file;
  std::string text, shown;  ///< shown: how errors call it
  fmi::Xml xml;
  xml_node root;
  Definitions defined;
  Documents& others;

  /// The file that an attribute names, beside this one. Throws Error for what is no relative URI, and for one
  /// that leads out of an archive.
  std::filesystem::path beside(xml_node of, const char* attribute) const;
};

/// Those that have been read, each once.
class Documents {
 public:
  const Document& open(const std::filesystem::path& file, std::string_view root);

 private:
  std::map<std::filesystem::path, std::unique_ptr<Document>> all_;
};

/// The description that an archive holds.
std::filesystem::path description_in(const std::filesystem::path& archive);

/// The element that says the type of a connector or a parameter; null: none does.
xml_node type_of(xml_node one);

/// The attributes of tandem's own annotation of an element, by name (docs/ssp.md); none if it has none.
std::map<std::string, std::string> own_annotation(const Document& document, xml_node of);

}  // namespace tandem::ssp
