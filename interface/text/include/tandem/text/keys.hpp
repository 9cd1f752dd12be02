// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::text {

/// A key of a language of files: what its files are read by, and its page, its schema and its help are made
/// from.
struct Key {
  enum class Type {
    text,
    word,  ///< One of `words`, or of those of `pattern`.
    number,
    positive,  ///< A number above 0.
    flag,
    texts,
    value,    ///< A number, a flag or a text.
    values,   ///< One of these, an array of numbers or of texts, or a table of all that.
    numbers,  ///< A number, or an array of them.
    vector,   ///< An array of numbers.
    factors,  ///< A table of numbers by name.
    matrix,   ///< A number, or an array of arrays of them.
    name,     ///< A number or a text.
    signal,   ///< A signal of a diagram, or a number.
    signals,  ///< An array of these.
    edge,     ///< A text, or an array of texts.
    edges,    ///< An array of these.
    table,
    numbers_or_table,
    tables,  ///< An array of tables.
    itself,  ///< A table with what a whole file has.
    any,     ///< What `allowed` says.
  };
  /// "coordination.order"; NAME stands for any name, and [] for each of an array of tables.
  std::string path;
  Type type;
  std::string sentence;        ///< its meaning
  std::string unit = {};       ///< SI; empty: none
  std::string otherwise = {};  ///< the value that holds where the key is not there; empty: none
  std::string allowed = {};    ///< what an error and the page say is allowed besides
  bool required = false;
  std::vector<std::string> words = {};
  std::string pattern = {};                    ///< a regular expression of further words, for the schema
  bool (*also)(const std::string&) = nullptr;  ///< whether one is one of these
  /// Of tables that say by a key `kind` what they are, the kinds that have this key; empty: all. A key for
  /// the table itself with a kind has that kind's sentence.
  std::vector<std::string> kinds = {};

  /// Of a word.
  bool allows(const std::string& word) const;
};

/// What the page says that the value of a key is: "a number above 0 [s]".
std::string described(const Key& key);

/// All keys of a language, tables before what they hold.
class Keys {
 public:
  enum class Texts {
    plain,
    refer,            ///< "$NAME" and "$(EXPRESSION)" may stand for a number or a word
    refer_in_arrays,  ///< also for one of an array of texts
  };
  explicit Keys(std::vector<Key> keys, Texts texts = Texts::plain);

  const std::vector<Key>& all() const { return keys_; }
  bool refer() const { return texts_ != Texts::plain; }
  bool refer_in_arrays() const { return texts_ == Texts::refer_in_arrays; }
  /// By its path as it stands in the list, in a table of that kind; null if it is not there.
  const Key* find(std::string_view path, std::string_view kind = {}) const;
  /// Those of a table of that kind, "" for the file; with no kind those of every one.
  std::vector<const Key*> in(std::string_view table, std::string_view kind = {}) const;
  /// The kinds of a table, with the sentence of each; empty: it has none.
  std::vector<const Key*> kinds(std::string_view table) const;
  /// By a path as a user writes it, "subsystems.motor.land", "connections.gain". NAME is any name there, or
  /// left out, and [] can be left out or have a number in it. Where a table has kinds, its name may be one of
  /// these. More than one where keys of kinds have one name, none if there is none.
  std::vector<const Key*> matching(const std::string& path) const;
  /// Throws Error that tells which is near a path for which there is none.
  [[noreturn]] void refuse(const std::string& path) const;

  /// Tables in Markdown: one for each table of the language.
  std::string page() const;

 private:
  bool may_be_in(const Key& key, const std::vector<std::string>& asked) const;
  std::string titled(const Key& table) const;
  bool holds_tables_alone(const Key& table) const;

  std::vector<Key> keys_;
  Texts texts_;
  std::multimap<std::string, std::size_t, std::less<>> by_path_;
};

/// The name of a key in its table: "gain" of "connections[].gain".
std::string name_of(const Key& key);

}  // namespace tandem::text
