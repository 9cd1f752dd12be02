// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/values.hpp"

#include "tandem/nearest.hpp"
#include "tandem/text/section.hpp"

namespace tandem::text {

bool Values::refers(const toml::node& node) {
  const auto* text = node.as_string();
  return text && text->get().starts_with("$") && !text->get().starts_with("$$");
}

FileValue Values::value(const Document& document, const toml::node& node, const std::string& what) const {
  return located(document.place(node), [&] {
    try {
      return referred(node.as_string()->get(), values_);
    } catch (const Error& error) {
      throw Error(error.code(), what + ": " + error.what());
    }
  });
}

double Values::number(const Document& document, const toml::node& node, const std::string& what) const {
  if (!refers(node)) return number_of(document, node, what);
  const FileValue found = value(document, node, what);
  if (const auto* number = std::get_if<double>(&found)) return *number;
  refuse(document.place(node), what + " is " + described(node) + ", for the word '" +
                                   std::get<std::string>(found) + "'; allowed is a number");
}

bool Values::is_number(const toml::node& node) const {
  if (!refers(node)) return node.is_number();
  const std::string text = node.as_string()->get();
  const auto it = values_.find(text.substr(1));
  return text.starts_with("$(") || (it != values_.end() && std::holds_alternative<double>(it->second));
}

}  // namespace tandem::text
