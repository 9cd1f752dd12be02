// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/schema.hpp"

namespace tandem::scenario {
namespace {

using Json = nlohmann::ordered_json;
using text::Key;
using text::Keys;

Json words_of(const Key& key) {
  const Json words = {{"enum", key.words}};
  if (key.pattern.empty()) return words;
  return {{"anyOf", {words, {{"type", "string"}, {"pattern", "^" + key.pattern + "$"}}}}};
}

Json type_of(const Key& key) {
  using Type = Key::Type;
  const Json number = {{"type", "number"}};
  switch (key.type) {
    case Type::text:
      return {{"type", "string"}};
    case Type::word:
      return words_of(key);
    case Type::number:
      return number;
    case Type::positive:
      return {{"type", "number"}, {"exclusiveMinimum", 0}};
    case Type::flag:
      return {{"type", "boolean"}};
    case Type::texts:
      return {{"type", "array"}, {"items", {{"type", "string"}}}};
    case Type::value:
      return {{"type", {"number", "boolean", "string"}}};
    case Type::numbers:
      return {{"anyOf", {number, {{"type", "array"}, {"items", number}}}}};
    case Type::name:
      return {{"type", {"number", "string"}}};
    case Type::table:
    case Type::tables:
      break;
  }
  return {{"type", "object"}};
}

Json object(const Keys& language, const std::string& path);

Json of(const Keys& language, const Key& key) {
  Json one;
  if (key.type == Key::Type::table)
    one = object(language, key.path);
  else if (key.type == Key::Type::tables)
    one = {{"type", "array"}, {"items", object(language, key.path)}};
  else
    one = type_of(key);
  one["description"] = key.sentence;
  return one;
}

/// A table, with all that it may hold.
Json object(const Keys& language, const std::string& path) {
  Json one = {{"type", "object"}, {"additionalProperties", false}};
  for (const std::string& name : language.in(path)) {
    const std::string inner = path.empty() ? name : path + "." + name;
    const Key* key = language.find(inner);
    if (!key) key = language.find(inner + "[]");
    if (name == "NAME")
      one["additionalProperties"] = of(language, *key);
    else
      one["properties"][name] = of(language, *key);
    if (key->required) one["required"].push_back(name);
  }
  return one;
}

}  // namespace

Json schema(const Keys& language, const std::string& title) {
  Json all = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  all.update(object(language, ""));
  return all;
}

}  // namespace tandem::scenario
