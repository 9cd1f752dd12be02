// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "../number_text.hpp"
#include "tandem/error.hpp"

namespace tandem {

/// "subsystem 'slow', advance at t = 5.25 s to 5.5 s": how each error of such a call begins.
inline std::string advance_of(const std::string& name, double begin, double limit) {
  return "subsystem '" + name + "', advance at t = " + number_text(begin) + " s to " + number_text(limit) +
         " s";
}

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

/// The same of an advance: an error that does not tell the call and its span, as that of a transport does,
/// gets them too.
template <class Call>
auto named_advance(const std::string& name, double begin, double limit, const Call& call) {
  return named(name, [&] {
    try {
      return call();
    } catch (const Error& error) {
      const std::string sentence = error.what();
      if (sentence.find("advance at t = ") != std::string::npos) throw;
      throw Error(error.code(), advance_of(name, begin, limit) + ": " + sentence);
    }
  });
}

}  // namespace tandem
