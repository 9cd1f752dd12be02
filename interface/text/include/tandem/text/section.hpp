// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/text/document.hpp"
#include "tandem/text/keys.hpp"
#include "tandem/text/values.hpp"

namespace tandem::text {

/// A table of a document while it is read. Its reader asks for each key by name and type, and what nobody
/// asked for is refused. Every error names the place, the key, the value found and what is allowed. It may
/// have the keys of a language, which then says what is allowed, what is missing and what holds where a key
/// is not there.
class Section {
 public:
  /// path: "coordination" or "connections[0]"; empty for the whole document. values: what texts that begin
  /// with $ stand for, where the reader asks for a number or a text; null: they are texts.
  Section(const Document& document, const toml::table& table, std::string path,
          const Values* values = nullptr);
  /// The whole of a document in a language.
  Section(const Document& document, const Keys& language, const Values* values = nullptr);
  /// A table of a document in another language, `path`, read as the table `pattern` of this one.
  Section(const Document& document, const Keys& language, const toml::table& table, std::string path,
          std::string pattern);
  /// This one with other values.
  Section with(const Values& values) const {
    Section other = *this;
    other.values_ = &values;
    return other;
  }

  const toml::node* node(const std::string& key);  ///< null if it is not there
  std::optional<std::string> text(const std::string& key);
  std::optional<double> number(const std::string& key);  ///< finite
  std::optional<double> positive(const std::string& key);
  std::optional<bool> flag(const std::string& key);
  std::vector<std::string> texts(const std::string& key);  ///< an array of texts; empty if it is not there
  const toml::table* table(const std::string& key);

  // In a language.
  /// The table of a key, to be read; null if it is not there.
  std::optional<Section> section(const std::string& key);
  /// Of a file's, a table below that holds what a whole file does.
  Section inner(const toml::table& table, std::string path) const {
    return {*this, table, std::move(path), pattern_};
  }
  /// The table that this one holds by a name of the user's.
  Section of_name(const std::string& name);
  /// The tables that this one holds by name, in the order of the file.
  std::vector<std::pair<std::string, Section>> named_sections();
  /// Those of an array of tables.
  std::vector<Section> sections(const std::string& key);
  std::string required_text(const std::string& key);
  double required_number(const std::string& key);  ///< above 0, if the language says so
  [[noreturn]] void missing(const std::string& key) const;
  /// Its key `kind`; from here on it has the keys of that kind.
  std::string kind();
  /// Refuses a key of the language that has no meaning here.
  void leave_out(const std::string& key, const std::string& why);

  std::string required_text(const std::string& key, const std::string& allowed);
  /// Refuses the section for a key that is not there, or for one that looks like it misspelt.
  [[noreturn]] void missing(const std::string& key, const std::string& allowed) const;

  /// Refuses the keys that nobody asked for.
  void refuse_unknown() const;

  Place place() const { return document_.place(table_); }
  Place place(const std::string& key) const;  ///< of its value, or of the table if it is not there
  std::string name(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  [[noreturn]] void wrong(const std::string& key, const std::string& found, const std::string& allowed) const;

  const Document& document() const { return document_; }
  /// The number that a node of this section is, or stands for.
  double number_of(const toml::node& node, const std::string& name) const;
  /// The text that a node of this section, a text in quotes, is or stands for.
  std::string text_of(const toml::node& node, const std::string& key) const;
  const toml::table& table() const { return table_; }
  const std::string& path() const { return path_; }  ///< "connections[0]", empty for the document

 private:
  const Document& document_;
  const toml::table& table_;
  std::string path_;
  const Values* values_;
  const Keys* language_ = nullptr;
  std::string pattern_, kind_;  ///< its path in the language, and of what kind it is

  Section(const Section& outer, const toml::table& table, std::string path, std::string pattern);
  const Key* known(const std::string& key) const;
  std::optional<std::string> otherwise(const std::string& key) const;
  void check_word(const Key& known, const std::string& key, const std::string& word) const;
  void refuse_unread() const;
  [[noreturn]] void refuse_key(const std::string& key, const std::string& near) const;

  std::vector<std::string> asked_;
};

/// The number that a value is. Throws for another type, one that is not finite, and a whole number that a
/// double can't hold; `name` is what the sentence calls it.
double number_of(const Document& document, const toml::node& node, const std::string& name);

}  // namespace tandem::text
