// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "to_json.hpp"

#include "tandem/text/document.hpp"

namespace tandem::scenario {

nlohmann::ordered_json to_json(const toml::node& node) {
  nlohmann::ordered_json json;
  if (const auto* table = node.as_table()) {
    json = nlohmann::ordered_json::object();
    for (const auto& [key, value] : text::in_file_order(*table)) json[key] = to_json(*value);
  } else if (const auto* array = node.as_array()) {
    json = nlohmann::ordered_json::array();
    for (const toml::node& value : *array) json.push_back(to_json(value));
  } else if (const auto* word = node.as_string()) {
    json = word->get();
  } else if (const auto* flag = node.as_boolean()) {
    json = flag->get();
  } else if (const auto* whole = node.as_integer()) {
    json = whole->get();
  } else if (const auto* number = node.as_floating_point()) {
    json = number->get();
  } else {
    json = text::described(node);
  }
  return json;
}

}  // namespace tandem::scenario
