// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "tandem/printable.hpp"

namespace tandem::cli {

/// To standard output. Names and texts in it may be a stranger's, so that control characters other than ends of lines are
/// shown as such. Where it can't be written, the command's end tells.
template <class... Values>
void say(fmt::format_string<Values...> form, Values&&... values) {
  const std::string text = printable_lines(fmt::format(form, std::forward<Values>(values)...));
  std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace tandem::cli
