// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>

#include "tandem/printable.hpp"

namespace tandem::cli {

/// To standard output, as fmt::print: but names and texts in it may be a stranger's, so that control
/// characters other than ends of lines are shown as such.
template <class... Values>
void say(fmt::format_string<Values...> form, Values&&... values) {
  fmt::print("{}", printable_lines(fmt::format(form, std::forward<Values>(values)...)));
}

}  // namespace tandem::cli
