// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

#include "tandem/error.hpp"

namespace tandem::text {

/// Where a value stands: in a line of its file, or in an override from the command line.
struct Place {
  std::string file;
  int line = 0;             ///< 0: the file as a whole
  std::string set_by = {};  ///< the override, "--set KEY=VALUE"; empty: the file

  std::string text() const {
    if (!set_by.empty()) return file + ": " + set_by;
    return line > 0 ? file + ":" + std::to_string(line) : file;
  }
};

/// The word that begins what an override is called, and its source region's path.
inline const std::string set_prefix = "--set ";

[[noreturn]] inline void refuse(const Place& place, const std::string& sentence,
                                ErrorCode code = ErrorCode::invalid_argument) {
  throw Error(code, place.text() + ": " + sentence);
}

/// In the handler of an error: throws it again, with the place, unless it names a line of that file already. What has no room
/// stays so.
[[noreturn]] void throw_at(const Place& place, const Error& error);

/// The one place where an error of what a file names becomes one that tells where the file says so.
/// place_of(sentence) gives the place. An error that names a line of that file already stays as it is.
template <class Work, class PlaceOf>
auto located(const PlaceOf& place_of, const Work& work) -> decltype(work())
  requires requires { place_of(std::string()); }
{
  try {
    return work();
  } catch (const Error& error) {
    throw_at(place_of(error.what()), error);
  }
}

template <class Work>
auto located(const Place& place, const Work& work) -> decltype(work()) {
  return located([&](const std::string&) { return place; }, work);
}

}  // namespace tandem::text
