// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/engine/read.hpp"
#include "tandem/text/section.hpp"

namespace tandem::engine {

/// Files of diagrams that one reading needs, each read once.
class DiagramFiles {
 public:
  /// Refuses a diagram that contains itself, with the files from the one to the other.
  Description read(const std::filesystem::path& file, const ParameterValues& parameters);
  const text::Document& document(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, std::unique_ptr<text::Document>> documents_;
  std::vector<std::filesystem::path> open_;
};

/// Fills a Description, table by table.
class DiagramReader {
 public:
  /// root: the whole document, or the table in a block that holds a diagram.
  DiagramReader(text::Section root, ParameterValues given, DiagramFiles& files)
      : root_(std::move(root)), given_(std::move(given)), files_(files) {}

  Description read();

 private:
  using Section = text::Section;
  const text::Document& document() const { return root_.document(); }

  template <class Read>
  void each(const std::string& key, const Read& read);
  void read_loops();
  void read_parameter(const std::string& name, Section& section);
  ParameterValue given_or(const std::string& name, const ParameterValue& value, Section& section) const;
  void refuse_unknown_parameters() const;
  std::vector<std::string> known() const;

  Wire wire(const toml::node& node, const std::string& key) const;
  Value value(const toml::node& node, const std::string& key) const;
  void read_block(const std::string& name, Section& section);
  /// Keys of a block, or of a table in one.
  void read_values(Block& block, Section& section, const std::vector<std::string>& besides);
  bool read_tables(Block& block, const std::string& key, const toml::node& node, const Section& section);
  void read_nested(Block& block, Section& section);
  ParameterValues given_to(const toml::table& inner, Block& block, const Section& section) const;
  void refuse_other_unit(const toml::node& given, const std::string& unit, const std::string& key) const;
  void read_output(const std::string& name, Section& section);
  void read_limit(const std::string& name, Section& section);
  double limit(Section& section, const std::string& key, double otherwise) const;
  /// A text, or "$NAME" for that of a parameter.
  std::optional<std::string> text(Section& section, const std::string& key) const;

  Section root_;
  ParameterValues given_, parameters_;
  DiagramFiles& files_;
  Description to_;
};

}  // namespace tandem::engine
