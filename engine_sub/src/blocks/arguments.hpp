// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <set>
#include <string>
#include <vector>

#include "compile/lowering.hpp"

namespace tandem::engine {

/// The ports and parameters of a block while it is compiled: each is asked for by its key, and what nobody
/// asked for is refused. Errors name the block, the key, the value found and what is allowed.
class Arguments {
 public:
  Arguments(const Block& block, Lowering& to) : block_(block), to_(to) {}

  bool has(const std::string& key) const { return block_.values.count(key) != 0; }
  int wire(const std::string& key);
  int wire(const std::string& key, double otherwise) {
    return has(key) ? wire(key) : to_.constant(otherwise);
  }
  std::vector<int> wires(const std::string& key);
  double number(const std::string& key);
  double number(const std::string& key, double otherwise);
  double positive(const std::string& key);
  std::vector<double> numbers(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  std::string required_text(const std::string& key, const std::string& allowed);
  std::vector<std::string> texts(const std::string& key);
  /// Tables at a key; none if it is not there.
  const std::vector<Block>& tables(const std::string& key);
  /// The place of a word in a list, the first if the key is not there.
  std::size_t word(const std::string& key, const std::vector<std::string>& allowed);
  bool flag(const std::string& key, bool otherwise);

  [[noreturn]] void refuse(const std::string& key, const std::string& found,
                           const std::string& allowed) const;
  /// "block 'f' of kind polynomial"
  std::string owner() const { return "block '" + to_.full_name(block_.name) + "' of kind " + block_.kind; }
  const Block& block() const { return block_; }
  const std::string& where() const { return block_.where; }
  void refuse_unknown() const;

 private:
  const Value* find(const std::string& key);
  const Value& required(const std::string& key, const std::string& allowed);
  std::string place(const std::string& key) const;
  int slot(const std::string& key, const Wire& wire);

  const Block& block_;
  Lowering& to_;
  std::set<std::string> asked_;
};

}  // namespace tandem::engine
