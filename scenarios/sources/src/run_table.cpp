// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/run_table.hpp"

#include <optional>

#include "tandem/sources/file_parameters.hpp"
#include "tandem/text/section.hpp"

namespace tandem {

namespace {

class RunTable {
 public:
  RunTable(const text::Document& document, Parameters& to) : document_(document), to_(to) {}

  void take(const std::string& name, const toml::node& node) {
    if (to_.has(name)) return;
    if (const auto* inner = node.as_table(); inner && !inner->empty())
      for (const auto& [key, one] : text::in_file_order(*inner)) take(name + "." + key, *one);
    else if (text::Values::refers(node))
      set(name, referred(name, node));
    else if (const auto* text = node.as_string())
      to_.set(name, text::Values::literal(text->get()));
    else if (const auto* flag = node.as_boolean())
      to_.set(name, flag->get());
    else if (node.is_number())
      to_.set(name, text::number_of(document_, node, "run." + name));
    else
      text::refuse(document_.place(node), "run." + name + " is " + text::described(node) +
                                              "; allowed is a number, true, false or a text");
  }

 private:
  /// A parameter of the file has its value already.
  text::FileValue referred(const std::string& name, const toml::node& node) {
    const text::FileValue* const own = values().find(name);
    return own ? *own : values().value(document_, node, "run." + name);
  }
  void set(const std::string& name, const text::FileValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return to_.set(name, *number);
    to_.set(name, std::get<std::string>(value));
  }
  const text::Values& values() {
    if (!values_) values_ = file_values(document_, to_);
    return *values_;
  }

  const text::Document& document_;
  Parameters& to_;
  std::optional<text::Values> values_;
};

}  // namespace

void take_run_table(const text::Document& document, Parameters& to) {
  const toml::table* run = document.table()["run"].as_table();
  if (!run) return;
  file_values(document, to);  // which refuses in its place what a parameter can't be
  RunTable taken(document, to);
  for (const auto& [name, node] : text::in_file_order(*run))
    if (name != "start" && name != "stop" && name != "inputs") taken.take(name, *node);
}

}  // namespace tandem
