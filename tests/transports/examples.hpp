// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/shared_library/shared_library.hpp"
#include "two_mass/masses.hpp"

namespace tandem::test {

/// The two masses, and shared libraries.
inline Builtins library_sources() {
  Builtins builtins;
  two_mass::add_builtins(builtins);
  add_shared_library(builtins);
  return builtins;
}

/// The library of transports/examples/mass2.LANGUAGE, to be followed by its parameters.
inline std::string mass2_library(const std::string& language) {
  return "lib:" TANDEM_EXAMPLES "/example_mass2_" + language + ".so?";
}

inline std::vector<std::string> library_languages() {
#if TANDEM_FORTRAN
  return {"c", "cpp", "fortran"};
#else
  return {"c", "cpp"};
#endif
}

}  // namespace tandem::test
