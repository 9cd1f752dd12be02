// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/manifest.hpp"

#include <sstream>

#include "tandem/text/section.hpp"

namespace tandem::exported {
namespace {

template <class Values>
toml::table table_of(const Values& values) {
  toml::table table;
  for (const auto& [name, value] : values) table.insert(name, value);
  return table;
}

Parameters::Value value_of(const text::Document& document, const std::string& name, const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* flag = node.as_boolean()) return flag->get();
  return text::number_of(document, node, "parameters." + name);
}

}  // namespace

std::string written(const Manifest& manifest) {
  toml::table parameters;
  for (const auto& [name, value] : manifest.parameters)
    std::visit([&](const auto& one) { parameters.insert(name, one); }, value);
  toml::array overrides;
  for (const std::string& one : manifest.overrides) overrides.push_back(one);
  const toml::table all{{"token", manifest.token},
                        {"source", manifest.source},
                        {"type", manifest.interface == Interface::model_exchange ? "me" : "cs"},
                        {"overrides", overrides},
                        {"parameters", parameters},
                        {"starts", table_of(manifest.starts)}};
  std::ostringstream text;
  text << all << '\n';
  return text.str();
}

Manifest read_manifest(const std::filesystem::path& file) {
  const text::Document document(file);
  text::Section root(document, document.table(), "");
  Manifest manifest{
      root.text("token").value_or(""), root.text("source").value_or(""), root.texts("overrides"), {}};
  const std::string type = root.text("type").value_or("cs");
  if (type != "cs" && type != "me") root.wrong("type", "'" + type + "'", "'cs' or 'me'");
  if (type == "me") manifest.interface = Interface::model_exchange;
  if (const toml::table* table = root.table("parameters"))
    for (const auto& [name, node] : text::in_file_order(*table))
      manifest.parameters[name] = value_of(document, name, *node);
  if (const toml::table* table = root.table("starts"))
    for (const auto& [name, node] : text::in_file_order(*table))
      manifest.starts[name] = text::number_of(document, *node, "starts." + name);
  return manifest;
}

}  // namespace tandem::exported
