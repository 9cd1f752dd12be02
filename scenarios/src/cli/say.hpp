// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cstdio>
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

/// To standard error, at once: how far the work has come. What can't be written there does not end the work.
inline void show_progress(const std::string& text) {
  static_cast<void>(std::fputs(text.c_str(), stderr));
  static_cast<void>(std::fflush(stderr));
}

}  // namespace tandem::cli
