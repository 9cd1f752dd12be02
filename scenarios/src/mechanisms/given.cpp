// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/given.hpp"

namespace tandem::mechanisms {

text::GivenValues given_values(
    const text::Document& document,
    const std::function<std::optional<text::FileValue>(const std::string&)>& find) {
  text::GivenValues given;
  text::Values own;
  text::Section root(document, document.table(), "");
  for (const text::FileParameter& parameter : text::read_parameters(root, {}, own))
    if (const auto value = find(parameter.name)) given[parameter.name] = *value;
  return given;
}

}  // namespace tandem::mechanisms
