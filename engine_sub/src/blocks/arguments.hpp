// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <set>
#include <string>
#include <vector>

#include "compile/lowering.hpp"
#include "tandem/text/keys.hpp"

namespace tandem::engine {

/// The ports and parameters of a block while it is compiled, by the keys of its kind in the language of
/// diagrams, which says what holds where one is not there; a block of a compiled kind has none. What nobody
/// asked for is refused. Errors name the block, the key, the value found and what is allowed.
class Arguments {
 public:
  /// table: of the language, where it is not the block's own.
  Arguments(const Block& block, Lowering& to, const text::Keys* language, std::string table = "blocks.NAME");
  /// Those of a table in the block, "transitions[]".
  Arguments part(const std::string& key, const Block& table) {
    return {table, to_, language_, table_ + "." + key};
  }

  bool has(const std::string& key) const {
    return block_.values.contains(key) || block_.tables.contains(key);
  }
  int wire(const std::string& key);
  std::vector<int> wires(const std::string& key);
  double number(const std::string& key);
  double positive(const std::string& key);
  std::vector<double> numbers(const std::string& key);
  std::string text(const std::string& key);
  std::vector<std::string> texts(const std::string& key);
  /// Tables at a key; none if it is not there.
  const std::vector<Block>& tables(const std::string& key);
  /// The place of a word among those of the language.
  std::size_t word(const std::string& key);
  bool flag(const std::string& key);

  [[noreturn]] void refuse(const std::string& key, const std::string& found,
                           const std::string& allowed) const;
  /// "block 'f' of kind polynomial"
  std::string owner() const { return "block '" + to_.full_name(block_.name) + "' of kind " + block_.kind; }
  const Block& block() const { return block_; }
  const std::string& where() const { return block_.where; }
  void refuse_unknown() const;

 private:
  const text::Key* known(const std::string& key) const;
  const Value* find(const std::string& key);
  /// What stands there, or what holds without it.
  Value required(const std::string& key, const std::string& allowed);
  void refuse_unread(const std::string& key) const;
  int slot(const std::string& key, const Wire& wire);

  const Block& block_;
  Lowering& to_;
  const text::Keys* language_;
  std::string table_;
  std::set<std::string> asked_;
};

}  // namespace tandem::engine
