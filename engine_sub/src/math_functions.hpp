// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string_view>
#include <vector>

namespace tandem::engine {

using Function = double (*)(double);
using Function2 = double (*)(double, double);

template <class F>
struct Named {
  const char* name;
  F call;
};

/// What the blocks `function` and `function2` know.
extern const std::vector<Named<Function>> functions;
extern const std::vector<Named<Function2>> functions2;

/// Where that name, which is there, stands in one of these lists.
template <class List>
int number_of(const List& list, std::string_view name) {
  return static_cast<int>(
      std::find_if(list.begin(), list.end(), [name](const auto& f) { return f.name == name; }) -
      list.begin());
}

}  // namespace tandem::engine
