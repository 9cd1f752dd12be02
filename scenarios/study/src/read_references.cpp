// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_references.hpp"

#include "read_given.hpp"

namespace tandem::study {
namespace {

using text::Section;

Reference read_reference(const std::string& name, Section& section, const Study& study) {
  Reference one{.name = name, .place = section.place()};
  if (name == "none") refuse(section.place(), "a reference has the name none, which stands for no reference");
  if (const auto file = section.text("file")) one.file = study.file.parent_path() / *file;
  if (const auto scenario = section.text("scenario"))
    one.scenario = Given{"", *scenario, section.place("scenario")};
  one.per = section.texts("per");
  one.floor = *section.flag("floor");
  one.models = *section.flag("models");
  one.with = all_given(section, "with");
  one.set = all_given(section, "set");
  if (auto outputs = section.section("outputs"))
    for (const auto& [output, node] : text::in_file_order(outputs->table())) {
      if (!node->is_string()) outputs->wrong(output, text::described(*node), "the name of an output");
      one.outputs[output] = node->as_string()->get();
    }
  if (!one.file.empty())
    for (const char* key : {"scenario", "per", "floor", "models", "with", "set"})
      section.leave_out(key, "results are read from `file`");
  section.refuse_unknown();
  for (const std::string& column : one.per)
    check_column(section.place("per"), section.name("per"), column, study);
  for (const Given& with : one.with) check_column(with.place, section.name("with"), with.name, study);
  for (const Given& set : one.set) check_columns(set, section.name("set") + ".", study);
  return one;
}

}  // namespace

void read_references(Section& root, Study& to) {
  auto all = root.section("references");
  if (!all) return;
  for (auto& [name, section] : all->named_sections())
    to.references.push_back(read_reference(name, section, to));
}

}  // namespace tandem::study
