// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "languages/schema.hpp"

namespace tandem::scenario {
namespace {

using Json = nlohmann::ordered_json;
using text::Key;
using text::Keys;

Json any_of(std::vector<Json> all) { return all.size() == 1 ? all[0] : Json{{"anyOf", all}}; }

/// "$NAME" or "$(EXPRESSION)".
Json reference() { return {{"type", "string"}, {"pattern", "^[$]"}}; }

class Schema {
 public:
  explicit Schema(const Keys& language) : language_(language) {}

  /// A table, with all that it may hold.
  Json object(const std::string& path) const {
    Json one = table(path, language_.in(path));
    const auto kinds = language_.kinds(path);
    if (kinds.empty()) return one;
    one.erase("additionalProperties");  // each kind has its own
    for (const Key* kind : kinds)
      one["allOf"].push_back({{"if", {{"properties", {{"kind", {{"const", kind->kinds[0]}}}}}}},
                              {"then", table(path, language_.in(path, kind->kinds[0]))}});
    return one;
  }

 private:
  Json table(const std::string& path, const std::vector<const Key*>& keys) const {
    Json one = {{"type", "object"}, {"additionalProperties", false}};
    for (const Key* key : keys) {
      const std::string name = text::name_of(*key);
      if (name == "NAME")
        one["additionalProperties"] = of(*key);
      else if (key->path != path)
        one["properties"][name] = of(*key);
      if (key->required) one["required"].push_back(name);
    }
    return one;
  }

  Json of(const Key& key) const {
    Json one;
    if (key.type == Key::Type::table)
      one = object(key.path);
    else if (key.type == Key::Type::tables)
      one = array(object(key.path));
    else if (key.type == Key::Type::numbers_or_table)
      one = any_of({number(), array(number()), object(key.path)});
    else
      one = type_of(key);
    one["description"] = key.sentence;
    return one;
  }

  static Json array(const Json& items) { return {{"type", "array"}, {"items", items}}; }

  Json number(const Json& one = {{"type", "number"}}) const {
    return language_.refer() ? any_of({one, reference()}) : one;
  }

  Json words(const Key& key) const {
    std::vector<Json> all = {{{"enum", key.words}}};
    if (!key.pattern.empty()) all.push_back({{"type", "string"}, {"pattern", "^" + key.pattern + "$"}});
    if (language_.refer()) all.push_back(reference());
    return any_of(all);
  }

  Json type_of(const Key& key) const {
    using Type = Key::Type;
    const Json text = {{"type", "string"}}, name = {{"type", {"number", "string"}}},
               edge = any_of({text, array(text)});
    switch (key.type) {
      case Type::text:
        return text;
      case Type::word:
        return words(key);
      case Type::number:
        return number();
      case Type::positive:
        return number({{"type", "number"}, {"exclusiveMinimum", 0}});
      case Type::flag:
        return {{"type", "boolean"}};
      case Type::texts:
        return array(text);
      case Type::value:
        return {{"type", {"number", "boolean", "string"}}};
      case Type::values:
        return any_of({{{"type", {"number", "boolean", "string", "object"}}},
                       {{"type", "array"}, {"minItems", 1}, {"items", name}}});
      case Type::numbers:
        return any_of({number(), array(number())});
      case Type::vector:
        return array(number());
      case Type::factors:
        return {{"type", "object"}, {"additionalProperties", number()}};
      case Type::matrix:
        return any_of({number(), array(array(number()))});
      case Type::name:
      case Type::signal:
        return name;
      case Type::signals:
        return array(name);
      case Type::edge:
        return edge;
      case Type::edges:
        return array(edge);
      case Type::itself:
        return {{"$ref", "#"}};
      case Type::any:
      case Type::table:
      case Type::numbers_or_table:
      case Type::tables:
        break;
    }
    return Json::object();
  }

  const Keys& language_;
};

}  // namespace

Json schema(const Keys& language, const std::string& title) {
  Json all = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  all.update(Schema(language).object(""));
  return all;
}

}  // namespace tandem::scenario
