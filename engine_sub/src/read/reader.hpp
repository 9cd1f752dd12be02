// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tandem/engine/read.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::engine {

/// Values of parameters, and those of them that name files only below a folder.
struct Given {
  ParameterValues values;
  std::set<std::string> bounded;
};

/// Files of diagrams that one reading needs, each read once.
class DiagramFiles {
 public:
  explicit DiagramFiles(const std::filesystem::path& bound)
      : bound_(std::filesystem::weakly_canonical(bound.empty() ? "." : bound)) {}

  /// Refuses a diagram that contains itself, with the files from the one to the other.
  Description read(const text::Document& file, const Given& given);
  const text::Document& document(const std::filesystem::path& file);
  /// Counts a block; refuses more than a system can have. (A few files that contain each other twice, and so
  /// on, stand for millions.)
  void count_block(const text::Place& place);
  /// Reads a nested diagram by `read`, one deeper.
  template <class Read>
  Description nested(const text::Place& place, const Read& read) {
    check_depth(place);
    ++depth_;
    Description inner = read();
    --depth_;
    return inner;
  }
  /// Whether it is below the folder of bounded values, links resolved.
  bool in_bounds(const std::filesystem::path& file) const;

 private:
  void check_depth(const text::Place& place) const;

  std::filesystem::path bound_;
  std::map<std::filesystem::path, std::unique_ptr<text::Document>> documents_;
  std::vector<std::filesystem::path> open_;
  int blocks_ = 0, depth_ = 0;
};

/// diagram_keys() without kinds of blocks in C++, which are not known while a file is read.
const text::Keys& language_of_diagrams();

/// Fills a Description, table by table.
class DiagramReader {
 public:
  /// root: the whole document, or the table in a block that holds a diagram.
  DiagramReader(const text::Section& root, Given given, DiagramFiles& files)
      : root_(root.with(values_)), given_(std::move(given)), files_(files) {}

  Description read();

 private:
  using Section = text::Section;
  const text::Document& document() const { return root_.document(); }

  template <class Read>
  void each(const std::string& key, const Read& read);
  void read_loops();
  void refuse_beyond_bounds(const toml::node& node, const std::string& key) const;

  Wire wire(const toml::node& node, const std::string& key) const;
  Value value(const toml::node& node, const std::string& key) const;
  void read_blocks();
  void read_block(const std::string& name, Section& section);
  /// Keys of a block, or of a table in one.
  void read_values(Block& block, Section& section, const std::vector<std::string>& besides);
  bool read_tables(Block& block, const std::string& key, const toml::node& node, const Section& section);
  void read_nested(Block& block, Section& section);
  Given given_to(const toml::table& inner, Block& block, const Section& section) const;
  void refuse_other_unit(const toml::node& given, const std::string& unit, const std::string& key) const;
  void read_output(const std::string& name, Section& section);
  void read_limit(const std::string& name, Section& section);

  bool is_bounded(const toml::node& node) const;

  text::Values values_;
  Section root_;
  Given given_;
  DiagramFiles& files_;
  Description to_;
};

}  // namespace tandem::engine
