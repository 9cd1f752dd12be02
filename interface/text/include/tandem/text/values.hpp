// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/text/document.hpp"
#include "tandem/text/expression.hpp"

namespace tandem::text {

/// What a file's texts that begin with $ stand for: "$NAME" for the value of a parameter, "$(EXPRESSION)" for
/// a number, an expression of parameters (expression.hpp). "$$TEXT" is the text "$TEXT".
class Values {
 public:
  void set(const std::string& name, FileValue value) { values_[name] = std::move(value); }
  /// Null: there is none of that name.
  const FileValue* find(const std::string& name) const {
    const auto it = values_.find(name);
    return it == values_.end() ? nullptr : &it->second;
  }

  /// Whether a node is a text that begins with one $.
  static bool refers(const toml::node& node);
  /// A text that stands for itself: without the first of two $.
  static std::string literal(const std::string& text) {
    return text.starts_with("$$") ? text.substr(1) : text;
  }
  /// Of such a node. Throws Error for a parameter that there is not, an expression that is none, and one that
  /// is not finite, with its parameters' values; `what` is what the sentence calls the node.
  FileValue value(const Document& document, const toml::node& node, const std::string& what) const;
  /// Of any node: the number that it is (number_of), or stands for.
  double number(const Document& document, const toml::node& node, const std::string& what) const;
  /// Whether a node is a number, or stands for one.
  bool is_number(const toml::node& node) const;

 private:
  FileValues values_;
};

}  // namespace tandem::text
