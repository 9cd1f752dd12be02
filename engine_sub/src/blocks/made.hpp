// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "arguments.hpp"
#include "compile/refuse.hpp"

namespace tandem::engine {

/// What make() gives; what it refuses without a place gets that of the block.
template <class Make>
auto made(const Arguments& a, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    if (std::string(error.what()).starts_with(a.where() + ": ")) throw;
    refuse(a.where(), error.what());
  }
}

}  // namespace tandem::engine
