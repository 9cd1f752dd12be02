// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/error.hpp"

namespace tandem {

/// Makes the call; an error of the subsystem's own that does not name it yet is thrown again with its name.
template <class Call>
auto named(const std::string& name, const Call& call) {
  try {
    return call();
  } catch (const Error& error) {
    const std::string sentence = error.what();
    if (sentence.find("'" + name + "'") != std::string::npos) throw;
    throw Error(error.code(), "subsystem '" + name + "': " + sentence);
  }
}

}  // namespace tandem
